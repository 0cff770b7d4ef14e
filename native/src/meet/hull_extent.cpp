#include "hull_extent.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>

namespace splinecore {

Interval extent_along(std::span<const glm::dvec3> points, const glm::dvec3& axis, const glm::dvec3& origin) {
  Interval extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const glm::dvec3& p : points) {
    const double at = glm::dot(p - origin, axis);
    extent.start = std::min(extent.start, at);
    extent.end = std::max(extent.end, at);
  }
  return extent;
}

bool is_outside_slab(std::span<const glm::dvec4> points, const glm::dvec3& axis, const Interval& slab) {
  bool is_above = true;
  bool is_below = true;
  for (const glm::dvec4& h : points) {
    const double along = glm::dot(glm::dvec3(h), axis);
    const double over = along - h.w * slab.end;
    const double under = along - h.w * slab.start;
    is_above = is_above && over > 0.0 && under > 0.0;
    is_below = is_below && over < 0.0 && under < 0.0;
  }
  return is_above || is_below;
}

bool are_apart_along(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, std::span<const glm::dvec3> axes,
                     double distance) {
  return std::ranges::any_of(axes, [&](const glm::dvec3& axis) {
    const Interval of_a = extent_along(a, axis, a.front());
    const Interval of_b = extent_along(b, axis, a.front());
    return of_a.start - of_b.end > distance || of_b.start - of_a.end > distance;
  });
}

bool are_boxes_apart(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, double distance) {
  const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  return are_apart_along(a, b, axes, distance);
}

}  // namespace splinecore
