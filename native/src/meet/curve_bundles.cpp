#include "curve_bundles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "box_tree.hpp"

namespace splinecore {

namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

glm::dvec3 middle_of(const CurvePart& part) {
  return part.is_boxed ? 0.5 * part.points.front() + 0.5 * part.points.back() : glm::dvec3(0.0);
}

/// A direction across a unit vector, that of another one unless what is across in it is rounding.
glm::dvec3 across(const glm::dvec3& unit, const glm::dvec3& other) {
  const glm::dvec3 beside = other - glm::dot(other, unit) * unit;
  const double length = glm::length(beside);
  constexpr double kRounding = 0x1p-26;
  if (length > kRounding * glm::length(other)) {
    const glm::dvec3 one = beside / length;
    return glm::normalize(one - glm::dot(one, unit) * unit);
  }
  const glm::dvec3 steps = glm::abs(unit);
  const glm::dvec3 axis = steps.x <= steps.y && steps.x <= steps.z ? glm::dvec3(1, 0, 0)
                          : steps.y <= steps.z                     ? glm::dvec3(0, 1, 0)
                                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(unit, axis));
}

}  // namespace

CurveBundles::CurveBundles(std::span<const CurvePart> parts) : of_parts_(parts.size()) {
  hulls_.reserve(parts.size());
  for (const CurvePart& part : parts) {
    const glm::dvec3 way = part.is_boxed ? part.points.back() - part.points.front() : glm::dvec3(0.0);
    hulls_.push_back({part.is_boxed, middle_of(part), way, points_.size(), points_.size() + part.points.size()});
    points_.insert(points_.end(), part.points.begin(), part.points.end());
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bundles_.reserve(2 * parts.size());
  add(order);
  hulls_ = {};
  points_ = {};
}

/// The first direction along parts, whichever way these go, the second to where they lie beside each other; of one part
/// to where it bends.
std::array<glm::dvec3, 3> CurveBundles::axes_of(std::span<const std::size_t> some) const {
  glm::dvec3 sum(0.0);
  for (const std::size_t i : some) sum += glm::dot(sum, hulls_[i].way) < 0.0 ? -hulls_[i].way : hulls_[i].way;
  const double length = glm::length(sum);
  const glm::dvec3 along = length > 0.0 ? sum / length : glm::dvec3(1, 0, 0);
  glm::dvec3 farthest(0.0);  // as seen along them
  double most = 0.0;
  const auto look = [&](const glm::dvec3& offset) {
    const glm::dvec3 beside = offset - glm::dot(offset, along) * along;
    if (!(glm::dot(beside, beside) > most)) return;
    most = glm::dot(beside, beside);
    farthest = offset;
  };
  const Hull& first = hulls_[some.front()];
  for (const std::size_t i : some) look(hulls_[i].middle - first.middle);
  if (some.size() == 1) {
    for (std::size_t k = first.first; k < first.end; ++k) look(points_[k] - points_[first.first]);
  }
  const glm::dvec3 second = across(along, farthest);
  return {along, second, glm::cross(along, second)};
}

std::size_t CurveBundles::add(std::span<std::size_t> some) {
  breathe(64 * some.size());
  const std::size_t own = bundles_.size();
  const std::array<glm::dvec3, 3> axes = axes_of(some);
  const auto seen = [&](const glm::dvec3& p) {
    return glm::dvec3(glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2]));
  };
  bool is_boxed = true;
  TreeBox all{glm::dvec3(kEverywhere), glm::dvec3(-kEverywhere)};
  TreeBox middles = all;
  const auto take = [](TreeBox& box, const glm::dvec3& p) { box = {glm::min(box.low, p), glm::max(box.high, p)}; };
  for (const std::size_t i : some) {
    const Hull& hull = hulls_[i];
    is_boxed = is_boxed && hull.is_boxed;
    take(middles, seen(hull.middle));
    for (std::size_t k = hull.first; k < hull.end; ++k) take(all, seen(points_[k]));
  }
  glm::dvec3 center(0.0);
  glm::dvec3 half(kEverywhere);
  if (is_boxed) {
    const glm::dvec3 middle = 0.5 * all.low + 0.5 * all.high;
    for (int k = 0; k < 3; ++k) center += middle[k] * axes[static_cast<std::size_t>(k)];
    half = 0.5 * (all.high - all.low);
  }
  const glm::dvec3 widths = middles.high - middles.low;
  const std::size_t widest = widths.x >= widths.y && widths.x >= widths.z ? 0 : widths.y >= widths.z ? 1 : 2;
  bundles_.push_back({center, axes, half, some.size(), some.front(), 0});
  if (some.size() == 1) {
    of_parts_[some.front()] = own;
    return own;
  }
  const std::size_t count = some.size() / 2;
  const auto place = [&](std::size_t i) { return std::pair(glm::dot(hulls_[i].middle, axes[widest]), i); };
  std::ranges::nth_element(some, some.begin() + static_cast<std::ptrdiff_t>(count), {}, place);
  const std::size_t first = add(some.first(count));
  const std::size_t second = add(some.subspan(count));
  bundles_[own].first = first;
  bundles_[own].second = second;
  return own;
}

std::size_t CurveBundles::count_near(const CurveBundle& box, double distance) const {
  constexpr double kThin = 2.0;
  const double thickness = kThin * std::max(box.half.y, box.half.z);
  const auto is_thin = [&](const CurveBundle& bundle) {
    const auto reach = [&](const glm::dvec3& axis) {
      const auto& [x, y, z] = bundle.axes;
      const glm::dvec3 slopes(glm::dot(axis, x), glm::dot(axis, y), glm::dot(axis, z));
      return glm::dot(glm::abs(slopes), bundle.half);
    };
    return std::max(reach(box.axes[1]), reach(box.axes[2])) <= thickness;
  };
  std::size_t near = 0;
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    breathe(32);
    const CurveBundle& bundle = bundles_[open.back()];
    open.pop_back();
    if (are_apart(box, bundle, distance)) continue;
    if (bundle.parts == 1 || is_thin(bundle)) {
      near += bundle.parts;
    } else {
      open.push_back(bundle.first);
      open.push_back(bundle.second);
    }
  }
  return near;
}

bool are_apart(const CurveBundle& a, const CurveBundle& b, double distance) {
  const glm::dvec3 offset = b.center - a.center;
  std::array<glm::dvec3, 3> slopes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) slopes[i][j] = std::abs(glm::dot(a.axes[i], b.axes[j]));
  }
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(offset, a.axes[i])) > a.half[i] + glm::dot(slopes[i], b.half) + distance) return true;
    const glm::dvec3 column(slopes[0][i], slopes[1][i], slopes[2][i]);
    if (std::abs(glm::dot(offset, b.axes[i])) > b.half[i] + glm::dot(column, a.half) + distance) return true;
  }
  return false;
}

}  // namespace splinecore
