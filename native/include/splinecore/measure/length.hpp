#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// To which part of itself a length is found unless asked otherwise.
inline constexpr double kLengthTolerance = 1e-13;

/// The length of the curve between two parameters of its domain (S15). A periodic curve continues: there they may be
/// any numbers, and turns are counted.
///
/// Spans are cut at cusps, and where weights differ much. On each part, over separate parameters, the rules of Gauss
/// and Kronrod of 15 and 31 nodes, halved where they differ (adaptive quadrature; Davis and Rabinowitz 1984, 6.2). A
/// gap of the curve has no length.
/// @param tolerance  The length is off by at most so much of itself. Where rounding of the coordinates is more than
///                   that, as of a short part of a large curve, it is right to that rounding, and the error says so.
/// @throws InvalidShape unless start <= end, both in the domain of a plain curve, or where weights differ by so much
///         that their products are no numbers; PointAtInfinity if the curve runs to infinity there;
///         ToleranceNotReached, with an error above the tolerance, if that takes more than 20 000 parts and 64 a span.
Approximation<double> length(const NurbsCurve& curve, Interval range, double tolerance = kLengthTolerance);

/// The length of all of it.
Approximation<double> length(const NurbsCurve& curve);

}  // namespace splinecore
