#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The curve with `times` copies of a knot fewer: the one nearest in its control points, in the sum of
/// squares; points that the knot has no part in stay bit for bit (S15; The NURBS Book, §5.4).
///
/// Exact, but for rounding, where the curve is smooth enough at u.
/// @throws InvalidShape if u is not a knot inside the domain, or has fewer copies; of a periodic curve the
///         first knot keeps one copy. ToleranceNotReached with a tolerance (a length) that the error exceeds.
Approximation<NurbsCurve> remove_knot(const NurbsCurve& curve, double u, int times = 1,
                                      std::optional<double> tolerance = {});

/// The curve without the inner knots that can go while the error stays within the tolerance, least error first: knots
/// that nothing needs go before any that shapes the curve (after The NURBS Book, A5.9, verified by the true distance).
/// @throws InvalidShape unless tolerance >= 0.
Approximation<NurbsCurve> remove_knots(const NurbsCurve& curve, double tolerance);

}  // namespace splinecore
