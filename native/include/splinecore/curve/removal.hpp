#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The curve with `times` copies of a knot fewer: the one nearest in its control points, in the sum of
/// squares; points that the knot has no part in stay bit for bit (S15; The NURBS Book, §5.4).
///
/// Exact, but for rounding, where the curve is smooth enough at u.
/// @throws InvalidShape if u is no knot inside the domain, or has fewer copies; of a periodic curve the
///         first knot keeps one copy. ToleranceNotReached with a tolerance (a length) that the error exceeds.
Approximation<NurbsCurve> remove_knot(const NurbsCurve& curve, double u, int times = 1,
                                      std::optional<double> tolerance = {});

/// One copy of a knot fewer, with the distance from `original`, if that is within the tolerance and what is left
/// is a valid curve at all.
std::optional<Approximation<NurbsCurve>> removed_within(const NurbsCurve& curve, double u, const NurbsCurve& original,
                                                        double tolerance);

/// The curve without every inner knot that can go while the error stays within the tolerance.
/// @throws InvalidShape unless tolerance >= 0.
Approximation<NurbsCurve> remove_knots(const NurbsCurve& curve, double tolerance);

}  // namespace splinecore
