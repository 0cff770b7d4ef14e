#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// To which part of itself a length is found unless asked otherwise.
inline constexpr double kLengthTolerance = 1e-13;

/// The length of the curve between two parameters of its domain (S15). A periodic curve goes on: there they may be
/// any numbers, and turns are counted.
///
/// Spans are cut at cusps, and where weights differ much. On each part the rules of Gauss and Kronrod of 15 and 31 nodes,
/// halved where they differ (adaptive quadrature; Davis and Rabinowitz 1984, 6.2). A gap of the curve has no length.
/// @param tolerance  relative to the length; where rounding of the coordinates is more, the error says so
/// @throws InvalidShape unless start <= end, both in the domain of a plain curve; PointAtInfinity if the curve runs
///         to infinity there; ToleranceNotReached.
Approximation<double> length(const NurbsCurve& curve, Interval range, double tolerance = kLengthTolerance);

/// The length of all of it.
Approximation<double> length(const NurbsCurve& curve);

}  // namespace splinecore
