#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/stored_point.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The point of a homogeneous one at u and v by a division, where the kernels found no number.
/// @throws PointAtInfinity
glm::dvec3 settled_point(const NurbsPatch& patch, const glm::dvec4& h, double u, double v, AtInfinity at_infinity);

}  // namespace splinecore
#pragma GCC visibility pop
