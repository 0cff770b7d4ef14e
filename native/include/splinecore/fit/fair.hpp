#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/fit/rebuild.hpp"

namespace splinecore {

/// A curve on the same knots, with the same weights, that bends less and stays within the tolerance: the control points
/// of the polynomial spline with least sum of the mean squared distance and a multiple of the integral of the squared
/// second derivative, the largest multiple that the tolerance allows (Hoschek and Lasser 1993, §13.2; Reinsch 1967).
///
/// The ends of an open curve stay, with their tangents if asked for; of one that is not clamped as many control points
/// as decide its ends.
/// @returns the curve, and the largest distance at equal parameters: at most 1 % above the truth
/// @throws InvalidShape unless the tolerance is positive, the degree is 2 at least, all control points are finite, and
/// some multiple has a solution as far as numbers can tell: above degree 100 none may have.
Approximation<NurbsCurve> fair(const NurbsCurve& curve, double tolerance, KeptEnds ends = KeptEnds::points);

}  // namespace splinecore
