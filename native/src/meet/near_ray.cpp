#include "near_ray.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Two directions at right angles to one of length 1.
std::array<glm::dvec3, 2> directions_across(const glm::dvec3& way) {
  const glm::dvec3 steps = glm::abs(way);
  const int least = steps.x <= steps.y && steps.x <= steps.z ? 0 : steps.y <= steps.z ? 1 : 2;
  glm::dvec3 axis(0.0);
  axis[least] = 1.0;
  const glm::dvec3 first = glm::normalize(glm::cross(way, axis));
  return {first, glm::cross(way, first)};
}

}  // namespace

NearRay::NearRay(const Ray& ray, const NearSpace& space, std::size_t index) {
  constexpr double kFar = 0x1p190;
  constexpr double kRounding = 0x1p-51;
  require_coordinates(&ray.origin.x, "origins", index, 0);
  require_coordinates(&ray.direction.x, "directions", index, 0);
  const glm::dvec3 steps = glm::abs(ray.direction);
  const double largest = std::max({steps.x, steps.y, steps.z});
  if (!(largest > 0.0)) throw InvalidShape("directions" + index_text(index) + " is zero");
  const NearPoint origin = space.enter(ray.origin, kFar);
  if (origin.moved) throw InvalidShape("origins" + index_text(index) + " is too far away");
  const int exponent = std::ilogb(largest);
  for (int i = 0; i < 3; ++i) way[i] = std::ldexp(ray.direction[i], -exponent);
  const double length = glm::length(way);
  way /= length;
  step = std::ldexp(space.length(1.0) / length, -exponent);
  if (!(step > 0.0) || !std::isfinite(step)) {
    throw InvalidShape("directions" + index_text(index) + " is too " + (step > 0.0 ? "short" : "long"));
  }
  before = -glm::dot(origin.at, way);
  foot = origin.at + before * way;
  across = directions_across(way);
  noise = space.rounding() + kRounding * (1.0 + glm::length(origin.at));
}

void add_boxes_on(const NearRay& ray, const BoxGroup& group, std::size_t first, std::size_t count,
                  std::vector<BoxOnRay>& met) {
  const glm::dvec3 d = ray.way;
  const glm::dvec3 steps = glm::abs(d);
  const double slack = NearRay::kSlack * ray.noise;
  breathe(kBoxGroup);
  for (std::size_t i = 0; i < std::min(count, kBoxGroup); ++i) {
    const glm::dvec3 m = glm::dvec3(group.middle[0][i], group.middle[1][i], group.middle[2][i]) - ray.foot;
    const glm::dvec3 h(group.half[0][i], group.half[1][i], group.half[2][i]);
    const bool is_met = std::abs(m.y * d.z - m.z * d.y) <= h.y * steps.z + h.z * steps.y + slack &&
                        std::abs(m.z * d.x - m.x * d.z) <= h.z * steps.x + h.x * steps.z + slack &&
                        std::abs(m.x * d.y - m.y * d.x) <= h.x * steps.y + h.y * steps.x + slack;
    if (!is_met) continue;
    const double middle = glm::dot(m, d);
    const double half = glm::dot(h, steps) + slack;
    met.push_back({middle - half, middle + half, first + i});
  }
}

void add_boxes_on(const NearRay& ray, const TurnedBoxGroup& group, std::size_t first, std::size_t count,
                  std::vector<BoxOnRay>& met) {
  const double slack = NearRay::kSlack * ray.noise;
  const std::array<glm::dvec3, 3> ways{ray.across[0], ray.across[1], ray.way};
  breathe(2 * kBoxGroup);
  for (std::size_t i = 0; i < std::min(count, kBoxGroup); ++i) {
    const glm::dvec3 m = glm::dvec3(group.center[0][i], group.center[1][i], group.center[2][i]) - ray.foot;
    const auto reach = [&](const glm::dvec3& way) {
      double half = slack;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 axis(group.axes[k][0][i], group.axes[k][1][i], group.axes[k][2][i]);
        half += group.half[k][i] * std::abs(glm::dot(axis, way));
      }
      return half;
    };
    if (std::abs(glm::dot(m, ways[0])) > reach(ways[0]) || std::abs(glm::dot(m, ways[1])) > reach(ways[1])) continue;
    const double middle = glm::dot(m, ways[2]);
    const double half = reach(ways[2]);
    met.push_back({middle - half, middle + half, first + i});
  }
}

void add_leaves_on(const NearRay& ray, const BoxTree& tree, std::vector<std::vector<BoxOnRay>>& waiting,
                   std::vector<BoxOnRay>& met) {
  waiting.resize(std::max(waiting.size(), tree.levels()));
  const std::size_t top = tree.levels() - 1;
  std::vector<BoxOnRay>& all = top == 0 ? met : waiting[top];
  all.clear();
  add_boxes_on(ray, tree.group(top, 0), 0, tree.count(top), all);
  for (std::size_t level = top; level > 0; --level) {
    std::vector<BoxOnRay>& below = level == 1 ? met : waiting[level - 1];
    below.clear();
    for (const BoxOnRay& box : waiting[level]) {
      const std::size_t first = box.index * BoxTree::kGroup;
      add_boxes_on(ray, tree.group(level - 1, box.index), first, tree.count(level - 1) - first, below);
    }
  }
}

}  // namespace splinecore
