#pragma once

#include <glm/vec3.hpp>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The arc of a circle from a point through another one to a third one. Row S10.
/// @throws InvalidShape if two are one or all lie on a line, up to rounding, or a number is not finite.
NurbsCurve arc_through(const glm::dvec3& start, const glm::dvec3& through, const glm::dvec3& end);

/// The arc from a point in a direction to another point.
/// @throws InvalidShape if the points are one, the direction is zero or along the line of both, or a number is not finite.
NurbsCurve arc_from_tangent(const glm::dvec3& start, const glm::dvec3& tangent, const glm::dvec3& end);

/// The arc about a center from a point, counterclockwise seen against the normal, to the direction of another one; a whole
/// circle where that is the same. The normal's part across the radius counts.
/// @throws InvalidShape if a point is the center, the normal is zero or along the radius, or a number is not finite.
NurbsCurve arc_about(const glm::dvec3& center, const glm::dvec3& start, const glm::dvec3& end, const glm::dvec3& normal);

}  // namespace splinecore
