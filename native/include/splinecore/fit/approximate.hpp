#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

struct ApproximationOptions {
  std::vector<double> weights;    ///< of the squared distances, positive, one for each point; empty: 1 each
  bool fixed_ends = true;         ///< an open curve begins at the first point and ends at the last
  std::vector<glm::dvec3> start;  ///< derivatives 1, 2, … at a fixed end
  std::vector<glm::dvec3> end;
  double smoothing = 0.0;  ///< weight of the integral of the squared second derivative, beside the sum of squares
  int corrections = 0;     ///< how often the parameters move to the nearest points and the curve is made again
};

/// Knots for a curve with a given number of control points: about as many parameters between each two (The NURBS Book, eq. 9.68,
/// 9.69). Where those are fewer than degree + 1: averages of `degree` places each (eq. 9.8), of as many places as there are
/// control points with as many parameters between each two; else single parameters would decide about control points that
/// they hardly move, and noise would swing the curve. With as many control points as points, those of interpolate(). Of a
/// closed curve, where parameters end with the return to the first point, periodic ones.
/// @throws InvalidShape if the control points are fewer than the degree needs, or more than the points.
KnotVector approximating_knots(std::span<const double> parameters, int degree, std::size_t count,
                               Closing closing = Closing::open);

/// The spline on these knots whose points at the parameters are nearest to the given points, in the sum of squares:
/// linear in the number of points (The NURBS Book, §9.4.1; lecture row S17). With smoothing: a penalised spline
/// (Reinsch 1967). Parameters are corrected by one step of Newton's method each (Hoschek 1988).
/// @param parameters  one for each point, increasing, in the domain of the knots
/// @returns the curve, and the largest distance of a point from the curve's point at its parameter
/// @throws InvalidShape if points, parameters and options do not belong together, or do not determine the curve.
Approximation<NurbsCurve> approximate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const KnotVector& knots, const ApproximationOptions& options = {});

/// The same on approximating_knots().
Approximation<NurbsCurve> approximate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      int degree, std::size_t count, Closing closing = Closing::open,
                                      const ApproximationOptions& options = {});

/// The curve on these knots with the least integral of the squared second derivative of those whose residual, the sum of
/// the squared distances times their weights, is no more (Reinsch 1967): that sum grows with the weight of smoothing, which
/// is found by halving. Of points that are noise about a curve with the deviation d it is about the number of points times
/// d^2; of those ends are best not fixed.
/// @returns the curve, and the largest distance of a point from the curve's point at its parameter
/// @throws InvalidShape unless the residual is 0 or more, if options have a smoothing or corrections, and as approximate();
///         ToleranceNotReached if it cannot be as small on these knots.
Approximation<NurbsCurve> approximate_smoothly(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                               const KnotVector& knots, double residual,
                                               const ApproximationOptions& options = {});

/// The same with knots where they are needed: spans that are too far from a point are halved, then knots that are not
/// missed are taken away. Curves that leave their points in between are not taken: by more than the size of a place's
/// neighborhood, that is of `degree` points on each side, or where no others are found by four times as much.
/// @param most  the largest number of control points
/// @returns the curve, and the largest distance of a point from the curve's point at its parameter
/// @throws ToleranceNotReached if they do not come within the tolerance; InvalidShape unless it is positive.
Approximation<NurbsCurve> approximate_within(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                             int degree, Closing closing, double tolerance, std::size_t most,
                                             const ApproximationOptions& options = {});

/// The same at chordal parameters, or at calm_parameters() where curves would swing at those.
Approximation<NurbsCurve> approximate_within(std::span<const glm::dvec3> points, int degree, Closing closing,
                                             double tolerance, std::size_t most,
                                             const ApproximationOptions& options = {});

}  // namespace splinecore
