#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// A conic, or any chain of rational quadratic arcs, as cubic Hermite segments (lecture row S10).
///
/// Each arc is halved until a cubic with its ends, its end tangents and its shoulder point is near
/// enough (Floater 1997 gives such cubics; their distance falls 64-fold with each halving). The error is a
/// bound of the distance from either curve to the other, derived beside the code. Joints of the
/// arcs stay points of the chain, and where the conic is smooth, the chain is C1.
/// @throws InvalidShape unless the degree is 2, the curve is finite and in one piece and the
///         tolerance is positive; ToleranceNotReached where halving leaves only rounding.
Approximation<HermiteCurve> conic_as_hermite(const NurbsCurve& curve, double tolerance);

}  // namespace splinecore
