#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// From 0 to pi.
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace splinecore
#pragma GCC visibility pop
