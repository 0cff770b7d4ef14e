#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The usual NURBS forms of a whole ellipse. Of all but `single` the spans are one apart.
enum class EllipseForm {
  square,    ///< four quarters, 9 points on a square, weights 1 and sqrt(1/2)
  triangle,  ///< three thirds, 7 points on a triangle, weights 1 and 1/2
  halves,    ///< two halves with directions between their ends, weights 1 and 0
  single     ///< one span of degree 5 without knots inside, weights 5 1 1 1 1 5 (Chou 1995)
};

/// The ellipse center + cos(a) axis_a + sin(a) axis_b from a = 0 once around. The axes are half
/// lengths with their directions; any two conjugate ones will do (lecture row S10; The NURBS Book, 7.5).
/// @throws InvalidShape if a number is not finite, or the axes are zero or parallel.
NurbsCurve ellipse(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b,
                   EllipseForm form = EllipseForm::square);

/// The circle at right angles to a normal, counterclockwise seen from its tip. It starts in the
/// direction of x for a normal along z, otherwise where plane_across() has its x axis.
/// @throws InvalidShape unless radius > 0, or if the normal is zero or a number is not finite.
NurbsCurve circle(const glm::dvec3& center, double radius, const glm::dvec3& normal,
                  EllipseForm form = EllipseForm::square);

/// The part of an ellipse from the angle `start` on, `sweep` radians long, clockwise where negative.
///
/// A span longer than half a turn has a negative weight, one of exactly half a turn a direction in
/// its middle. A sweep of a whole turn ends exactly where it begins. Angles within
/// rounding of a multiple of 15 degrees are that, so that its points have all their digits.
/// @param span_count  0 for as few as keep each within a quarter turn
/// @throws InvalidShape if the sweep is 0 or longer than a turn, one span would hold a whole turn, the
///         count is outside [0, 65536], and as for ellipse().
NurbsCurve ellipse_arc(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b, double start,
                       double sweep, int span_count = 0);

/// Both branches of the hyperbola center +- cosh(t) axis_a + sinh(t) axis_b, that to which axis_a points first.
///
/// Each is two spans from one asymptote's direction to the other's, with its vertex between. The axes are half
/// lengths with their directions; any two conjugate ones will do.
/// @throws InvalidShape if a number is not finite, or the axes are zero or parallel.
std::vector<NurbsCurve> hyperbola(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b);

}  // namespace splinecore
