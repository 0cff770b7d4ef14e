#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Points moved to their middle, and divided by a power of two so that the largest coordinate is near 1.
struct UnitPoints {
  std::vector<glm::dvec3> points;
  glm::dvec3 middle;
  int exponent;

  /// Where a point of theirs is.
  glm::dvec3 back(const glm::dvec3& point) const;
};

UnitPoints unit_points(std::span<const glm::dvec3> points);

}  // namespace splinecore
#pragma GCC visibility pop
