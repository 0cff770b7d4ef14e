#pragma once

#include <span>
#include <utility>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// All curves over the domain of the first, of one degree and on one knot vector: what it takes to go from one to the
/// others (The NURBS Book, 8.4, 10.3; S15).
///
/// The domains of the others are mapped; a knot that then lies within a few roundings of one of an earlier curve is taken
/// for it. Lower degrees are raised and the knots are merged. Periodic only if all are, otherwise clamped, unless the
/// knots are equal from the start.
/// @param knot_distance  knots nearer to each other than this part of the domain are taken for one, too: that moves the
///                       curves, which no rounding does
/// @throws InvalidShape if there is no curve, the distance is not from 0 to below 1, or mapped knots do not stay apart.
std::vector<NurbsCurve> compatible(std::span<const NurbsCurve> curves, double knot_distance = 0.0);

/// The same of two.
std::pair<NurbsCurve, NurbsCurve> compatible(const NurbsCurve& a, const NurbsCurve& b);

}  // namespace splinecore
