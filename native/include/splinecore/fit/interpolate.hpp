#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Where the knots of an open interpolating curve lie, and what it does at its ends.
enum class FitEnds {
  averaged,    ///< knots are averages of `degree` parameters each (The NURBS Book, eq. 9.8)
  not_a_knot,  ///< at the points, but for those next to the ends; of even degrees half-way between (de Boor 1978)
  natural,     ///< at the points; the derivatives (degree + 1)/2 … degree - 1 vanish at the ends: odd degrees
};

/// The first derivative that a curve has at one of its points.
struct PointTangent {
  std::size_t point;
  glm::dvec3 tangent;
};

struct InterpolationOptions {
  int degree = 3;
  Closing closing = Closing::open;
  FitEnds ends = FitEnds::averaged;
  std::vector<glm::dvec3> start;  ///< derivatives 1, 2, … at the first point; with `averaged` alone
  std::vector<glm::dvec3> end;
  std::vector<PointTangent> tangents;  ///< at points in between, in order; at the ends where closed
  std::vector<double> knots;           ///< all of them, one period where closed; empty: chosen
};

/// Parameters 0, … for a curve of this degree on averaged knots that stays near its points however uneven their distances
/// are: steps are the roots of the distances up to degree 3 (centripetal: Lee 1989), fourth roots of degree 4, eighth roots
/// of degree 5, and equal above. With steps nearer to the distances, points that crowd set high derivatives, with which the curve swings
/// over the long spans beside them. They end at the length of the polygon; where closed one more, of the return to the
/// first.
/// @throws InvalidShape as parameters_of(); only equal steps take two points in one place.
std::vector<double> calm_parameters(std::span<const glm::dvec3> points, int degree, Closing closing = Closing::open);

/// The polynomial spline through all points, with these derivatives (lecture row S17): linear in the number of points.
///
/// Each condition is a row of a banded system. Where derivatives are given a parameter counts once for each when knots
/// are averaged; with (degree - 1)/2 at each end of a curve of odd degree, and nowhere else, they lie at the points. A
/// closed curve is periodic; its knots lie at the points, of even degrees half-way between.
/// @param parameters  one for each point, and where closed one more for the return
/// @returns the curve, and the largest distance from a point that rounding left
/// @throws InvalidShape if there are fewer points than the degree needs, a number is not finite, parameters do not
///         increase, or the knots given do not belong to the points (Schoenberg and Whitney 1953).
Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const InterpolationOptions& options = {});

/// The same at calm_parameters(). Where neither knots nor derivatives nor other ends are given the curve stays near its points:
/// between two of them no farther from their chord than the longest chord, of which each counts three quarters as much
/// for every point that it is farther away. What swings wider at those parameters gets even ones: where open on even
/// knots, at the tops of their Chebyshev spline, through values at which goes no spline that is more than three times as
/// large, of whatever degree (Demko 1985).
/// @throws InvalidShape as both do
Approximation<NurbsCurve> interpolate_calmly(std::span<const glm::dvec3> points, const InterpolationOptions& options = {});

}  // namespace splinecore
