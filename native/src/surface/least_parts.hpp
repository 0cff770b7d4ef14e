#pragma once

#include <array>
#include <glm/vec3.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Numbers by which two vectors each of two sides add up to a vector, as nearly as may be, as seen in the mean of both planes;
/// the least such. What the planes differ by can be nobody's part: it would be divided by how little that is.
/// @param of_b  both zero where there is no second side
std::array<double, 4> least_parts(const glm::dvec3& vector, const std::array<glm::dvec3, 2>& of_a, const std::array<glm::dvec3, 2>& of_b);

}  // namespace splinecore
#pragma GCC visibility pop
