#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where points lie along an axis from an origin.
Interval extent_along(std::span<const glm::dvec3> points, const glm::dvec3& axis, const glm::dvec3& origin);

/// Whether what homogeneous points with weights of any signs span, through infinity, is nowhere between two planes across
/// an axis: the distances to both have one sign, by the weight's.
bool is_outside_slab(std::span<const glm::dvec4> points, const glm::dvec3& axis, const Interval& slab);

/// Whether points are farther apart than that, as seen along one of some axes, or of the axes of coordinates.
bool are_apart_along(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, std::span<const glm::dvec3> axes,
                     double distance);
bool are_boxes_apart(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
