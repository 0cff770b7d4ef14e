#pragma once

#include <optional>
#include <span>

#include "splinecore/conic/implicit_conic.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The conic through five points of a plane, the one member of the pencil of conics through four
/// of them that the fifth lies on (Semple and Kneebone 1952; lecture row S10). Its plane's origin lies in
/// the middle of the points.
///
/// Three points on a line give a pair of lines. A coefficient that is no more than what rounding
/// of the points leaves is zero, so that a parabola along an axis is one. The largest quadratic one is 1.
/// @param tolerance  a length: points closer than it coincide, points closer than it to a line or
///                   plane lie on it; 1e-9 of their extent where none is given
/// @throws InvalidShape naming the points unless there are five, in a plane, no two in one
///         place and no four on a line.
ImplicitConic conic_through(std::span<const glm::dvec3> points, std::optional<double> tolerance = std::nullopt);

/// The ellipse of the points whose distances from two foci have that sum where it is more than
/// the foci's own distance; where it is less, the hyperbola of those with that difference.
/// Foci in one place give a circle. The plane's origin lies between the foci, its x axis along them.
/// @param normal  of the plane wanted; its part across the line of foci counts
/// @throws InvalidShape if distance is not positive or is the foci's own, if the normal is zero or
///         along the foci, or a number is not finite.
ImplicitConic conic_by_foci(const glm::dvec3& focus_1, const glm::dvec3& focus_2, double distance,
                            const glm::dvec3& normal);

/// The parabola of the points as far from the focus as from a line. The plane's origin lies in
/// the vertex, its y axis points to the focus.
/// @throws InvalidShape if the focus lies on the line, the direction is zero or a number is not finite.
ImplicitConic parabola(const glm::dvec3& focus, const glm::dvec3& directrix_point,
                       const glm::dvec3& directrix_direction);

/// The part of a circle, an ellipse, a parabola or a hyperbola from one parameter to another.
///
/// The parameter of a circle or an ellipse is the angle from the axis in radians; that of a parabola the
/// distance from its axis; that of a hyperbola the area parameter of (first cosh, second sinh), on the
/// branch to which the axis points.
/// @throws InvalidShape if the conic is none of these, start = end, an arc is longer than a turn,
///         or a number is not finite.
NurbsCurve arc_between(const ImplicitConic& conic, double start, double end);

}  // namespace splinecore
