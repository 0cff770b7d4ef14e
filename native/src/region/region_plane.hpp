#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The control points of all curves.
std::vector<glm::dvec4> points_of(std::span<const NurbsCurve> curves);

/// What is so near is one, of curves that are seen together; no less than rounding leaves.
double region_tolerance(std::span<const NurbsCurve> curves, std::optional<double> tolerance);

/// The normal of the plane that curves lie in, towards +z; where that is at right angles to it, +y, and then +x.
/// @throws InvalidShape if they lie on a line
glm::dvec3 common_normal(std::span<const NurbsCurve> curves, double tolerance);

/// @throws InvalidShape naming a curve that leaves the plane of the first one
void require_one_plane(std::span<const NurbsCurve> curves, const glm::dvec3& normal, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
