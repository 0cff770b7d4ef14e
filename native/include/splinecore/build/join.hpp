#pragma once

#include <span>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// Bezier curves one after the other as one NURBS curve (lecture row S7).
///
/// All are raised to the highest degree, and each inner parameter is a knot of that multiplicity: so every
/// segment keeps its shape exactly, whatever the continuity is. Where the weights of two ends differ, those
/// of the later curve are scaled as a whole, which leaves its shape. A joint is the end of the curve before it.
/// @param parameters  one more than curves, increasing; empty means 0, 1, 2, …
/// @param tolerance   how far an end may lie from the next start
/// @throws InvalidShape if there is no curve, counts disagree, the parameters do not increase, or ends do
///         not meet or lie at infinity: the message has the joint's number, from 1.
NurbsCurve join_beziers(std::span<const BezierCurve> curves, std::vector<double> parameters = {},
                        double tolerance = 0.0);

}  // namespace splinecore
