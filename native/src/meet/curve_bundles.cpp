#include "curve_bundles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "hull_extent.hpp"

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

/// The first direction along parts, whichever way these go, the second to where they lie beside each other.
std::array<glm::dvec3, 3> axes_of(std::span<const CurvePart> parts, std::span<const std::size_t> some) {
  glm::dvec3 sum(0.0);
  for (const std::size_t i : some) {
    if (!parts[i].is_boxed) continue;
    const glm::dvec3 way = parts[i].points.back() - parts[i].points.front();
    sum += glm::dot(sum, way) < 0.0 ? -way : way;
  }
  const double length = glm::length(sum);
  const glm::dvec3 along = length > 0.0 ? sum / length : parts[some.front()].along;
  const glm::dvec3 from = middle_of(parts[some.front()]);
  glm::dvec3 farthest(0.0);  // as seen along them
  double most = 0.0;
  for (const std::size_t i : some) {
    const glm::dvec3 offset = middle_of(parts[i]) - from;
    const glm::dvec3 beside = offset - glm::dot(offset, along) * along;
    if (!(glm::dot(beside, beside) > most)) continue;
    most = glm::dot(beside, beside);
    farthest = offset;
  }
  const glm::dvec3 second = across(along, farthest);
  return {along, second, glm::cross(along, second)};
}

}  // namespace

CurveBundles::CurveBundles(std::span<const CurvePart> parts) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bundles_.reserve(2 * parts.size());
  add(parts, order);
}

std::size_t CurveBundles::add(std::span<const CurvePart> parts, std::span<std::size_t> some) {
  breathe(64 * some.size());
  const std::size_t own = bundles_.size();
  const std::array<glm::dvec3, 3> axes = axes_of(parts, some);
  const bool is_boxed = std::ranges::all_of(some, [&](std::size_t i) { return parts[i].is_boxed; });
  glm::dvec3 centre(0.0);
  glm::dvec3 half(kEverywhere);
  std::size_t widest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    Interval all{kEverywhere, -kEverywhere};
    Interval middles = all;
    for (const std::size_t i : some) {
      const double middle = glm::dot(middle_of(parts[i]), axes[k]);
      middles = {std::min(middles.start, middle), std::max(middles.end, middle)};
      if (!is_boxed) continue;
      const Interval one = extent_along(parts[i].points, axes[k], glm::dvec3(0.0));
      all = {std::min(all.start, one.start), std::max(all.end, one.end)};
    }
    if (is_boxed) {
      centre += all.middle() * axes[k];
      half[static_cast<int>(k)] = 0.5 * all.length();
    }
    if (middles.length() > most) widest = k;
    most = std::max(most, middles.length());
  }
  bundles_.push_back({centre, axes, half, some.size(), some.front(), 0});
  if (some.size() == 1) return own;
  const std::size_t count = some.size() / 2;
  const auto place = [&](std::size_t i) { return std::pair(glm::dot(middle_of(parts[i]), axes[widest]), i); };
  std::ranges::nth_element(some, some.begin() + static_cast<std::ptrdiff_t>(count), {}, place);
  const std::size_t first = add(parts, some.first(count));
  const std::size_t second = add(parts, some.subspan(count));
  bundles_[own].first = first;
  bundles_[own].second = second;
  return own;
}

bool are_apart(const CurveBundle& a, const CurveBundle& b, double distance) {
  const glm::dvec3 offset = b.centre - a.centre;
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
