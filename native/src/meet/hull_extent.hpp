#pragma once

#include <glm/vec3.hpp>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether points are farther apart than that, as seen along one of some axes, or of the axes of coordinates.
bool are_apart_along(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, std::span<const glm::dvec3> axes,
                     double distance);
bool are_boxes_apart(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
