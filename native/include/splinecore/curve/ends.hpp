#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The same curve over another interval: the knots are mapped, the points stay (S15).
/// @throws InvalidShape unless start < end, both finite, and the mapped knots stay apart.
NurbsCurve with_domain(const NurbsCurve& curve, Interval domain);

/// The same plain curve with both ends in its outer control points; a periodic one is cut at its seam.
NurbsCurve clamped(const NurbsCurve& curve);

/// The same curve on knots that continue outside the domain, so that it touches no end point (The NURBS Book,
/// A12.1; by blossoms): in steps of the span beside it, above degree 3 of (3 / degree)^2 of it, which keeps the
/// points near the curve. A periodic curve is unrolled.
/// @throws InvalidShape if weights at an end are so different that rounding would move the curve.
NurbsCurve unclamped(const NurbsCurve& curve);

/// The closed curve as a periodic one, as smooth at its seam as it is.
/// @param tolerance  how far the ends may lie apart and removing knots at the seam may move the curve;
///                   by default a few roundings of the largest coordinate
/// @throws ToleranceNotReached if the ends lie farther apart; InvalidShape if an end is at infinity.
Approximation<NurbsCurve> made_periodic(const NurbsCurve& curve, std::optional<double> tolerance = {});

/// The same periodic curve whose knots begin with all copies of the first, and end with one.
NurbsCurve with_whole_seam(const NurbsCurve& curve);

/// The same periodic curve over the period that begins at a parameter, which has a knot there.
NurbsCurve with_seam_at(const NurbsCurve& curve, double u);

}  // namespace splinecore
