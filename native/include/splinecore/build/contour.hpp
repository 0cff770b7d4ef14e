#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// A contour through points, of segments and arcs: those with a bulge, the tangent of a quarter of their angle, positive
/// for arcs that run counterclockwise seen against the normal, as in DXF files. As fast at joints on both sides. S18.
/// @param bulges  one for each part, that from the last to the first point of a closed one too; empty: all straight
/// @throws InvalidShape if there are fewer than two points, or counts disagree, two that follow each other are one, a
///         number is not finite, or the normal of an arc is along its chord or zero.
NurbsCurve contour(std::span<const glm::dvec3> points, std::span<const double> bulges, bool closed,
                   const glm::dvec3& normal);

}  // namespace splinecore
