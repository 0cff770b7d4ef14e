#pragma once

#include <glm/vec3.hpp>
#include <numbers>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// Angles in radians about an axis, counterclockwise seen from its tip: from `start` on, `sweep` long,
/// clockwise where negative. A whole turn makes a patch periodic in u.
struct Turn {
  double start = 0.0;
  double sweep = 2.0 * std::numbers::pi;
};

/// The surface of a curve that turns about an axis (The NURBS Book, A8.1; lecture row S20).
///
/// u runs about the axis, in spans of at most a quarter turn, one for each, v along the curve on its own knots.
/// The angle 0 is the curve where it is. Normals point away from the axis where the curve runs in its
/// direction: outwards for a closed profile that runs counterclockwise in the half plane of (distance from the
/// axis, height). A control point on the axis, but for rounding, makes a row of equal points: a pole.
/// Exact for every curve: rational, periodic, unclamped or with points at infinity.
/// @throws InvalidShape if the axis has no direction, a number is not finite, the sweep is zero or more than a
///         whole turn, or the curve lies on the axis.
NurbsPatch revolve(const NurbsCurve& curve, const glm::dvec3& axis_point, const glm::dvec3& axis_direction,
                   Turn turn = {});

/// The surface of a curve that moves along a vector: u along the curve, v from 0 to 1 (The NURBS Book, 8.3).
///
/// Normals point along C' x vector: outwards for a counterclockwise curve that is lifted.
/// @throws InvalidShape if the vector has no length or is not finite.
NurbsPatch extrude(const NurbsCurve& curve, const glm::dvec3& vector);

/// The surface of the segments from points of a to points of b at one parameter, v from 0 to 1 (The NURBS Book,
/// 8.4). u lies in the domain of a; that of b is mapped to it, see compatible().
///
/// Homogeneous points are interpolated: where the weights of both at u are equal, v is the share of the way from a
/// to b; otherwise the segment is the same, but parametrized otherwise. Weights of opposite signs
/// lead through infinity.
NurbsPatch ruled(const NurbsCurve& a, const NurbsCurve& b);

}  // namespace splinecore
