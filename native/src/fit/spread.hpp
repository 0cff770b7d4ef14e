#pragma once

#include <glm/vec3.hpp>
#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The direction in which points spread least about the origin, with its upper side up.
glm::dvec3 least_spread(std::span<const glm::dvec3> points);

}  // namespace splinecore
#pragma GCC visibility pop
