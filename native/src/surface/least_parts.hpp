#pragma once

#include <array>
#include <glm/vec3.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Numbers by which two vectors each of two sides add up to a vector, as nearly as may be; the least such.
std::array<double, 4> least_parts(const glm::dvec3& vector, const std::array<glm::dvec3, 2>& of_a, const std::array<glm::dvec3, 2>& of_b);

}  // namespace splinecore
#pragma GCC visibility pop
