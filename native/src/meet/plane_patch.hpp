#pragma once

#include <glm/vec4.hpp>
#include <span>

#include "splinecore/conic/plane.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A plane as a patch with its own coordinates as parameters, farther out than points.
NurbsPatch plane_about(std::span<const glm::dvec4> points, const Plane& plane);

}  // namespace splinecore
#pragma GCC visibility pop
