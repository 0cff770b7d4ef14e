#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/fit/rebuild.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A curve on the same knots, with the same weights, that bends less and stays within the tolerance: the control points
/// of the polynomial spline with least sum of the mean squared distance and a multiple of the integral of the squared
/// second derivative, the largest multiple that the tolerance allows (Hoschek and Lasser 1993, §13.2; Reinsch 1967).
/// Spans below 2⁻¹² of the mean one bend for nothing.
///
/// The ends of an open curve stay, with their tangents if asked for; of one that is not clamped as many control points
/// as decide its ends.
/// @returns the curve, and the largest distance at equal parameters: at most 1 % above the truth
/// @throws InvalidShape unless the tolerance is positive, the degree is 2 at least, all control points are finite, and
/// some multiple has a solution as far as numbers can tell: above degree 100 none may have.
Approximation<NurbsCurve> fair(const NurbsCurve& curve, double tolerance, KeptEnds ends = KeptEnds::points);

/// A patch on the same knots, with the same weights, that bends less and stays within the tolerance: the control points
/// of the polynomial spline with least sum of the mean squared distance and a multiple of the energy of a thin plate, the
/// mean of S_uu² + 2 S_uv² + S_vv² (Greiner 1994), the largest multiple that the tolerance allows.
///
/// The plate is as long and wide as the net on average, and so it is of no matter which domains the patch has. Borders
/// stay, and with tangents the derivatives across them: in a direction that is not clamped as many rows of control points
/// as decide a border.
/// @returns the patch, and the largest distance at equal parameters: at most 2 % above the truth
/// @throws InvalidShape unless the tolerance is positive, a degree is 2 at least, all weights have one sign, and some
/// multiple has a solution as far as numbers can tell: of two degrees above 11 none may have.
Approximation<NurbsPatch> fair(const NurbsPatch& patch, double tolerance, KeptEnds u = KeptEnds::points,
                               KeptEnds v = KeptEnds::points);

}  // namespace splinecore
