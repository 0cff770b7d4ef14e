#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// An origin near points that lie far from their own, by coordinates: those less it lose no digit (Sterbenz), and products
/// with weights are rounded by how large the shapes are, not by how far away. A coordinate that would be rounded stays.
glm::dvec3 common_origin(std::span<const glm::dvec4> a, std::span<const glm::dvec4> b);

/// Control points with an origin; directions stay.
std::vector<glm::dvec4> from_origin(std::span<const glm::dvec4> points, const glm::dvec3& origin);

}  // namespace splinecore
#pragma GCC visibility pop
