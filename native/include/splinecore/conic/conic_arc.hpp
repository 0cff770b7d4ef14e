#pragma once

#include <glm/vec3.hpp>

#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// What a rational quadratic Bezier curve is (lecture row S10).
///
/// Arcs named in the plural pass through infinity inside the curve. An arc of a parabola or a
/// hyperbola may also end at infinity. The last three are what three points on a line give.
enum class ConicArcClass {
  shorter_ellipse_arc,
  half_ellipse,
  longer_ellipse_arc,
  parabola_arc,
  two_parabola_arcs,
  hyperbola_arc,
  two_hyperbola_arcs,
  three_hyperbola_arcs,
  segment,
  line_through_infinity,
  point
};

/// The Bezier curve of three points with weights 1, w1, 1. With w1 = 0 it is the segment from
/// p0 to p2; a half ellipse has a direction in the middle instead: see ellipse_arc().
/// @throws InvalidShape if a number is not finite.
BezierCurve conic_arc(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2, double w1);

/// Any weights, also 0 and negative ones: only w1² against w0 w2 and the signs count.
///
/// Numbers count as equal, and points as collinear, when they are up to a few units in the last
/// place of what was given, so that w1 = sqrt(w0 w2) is a parabola.
/// @throws InvalidShape unless the degree is 2.
ConicArcClass conic_class(const BezierCurve& curve);

}  // namespace splinecore
