#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The same curve of a higher degree: every distinct knot has `times` copies more (S15).
/// @throws InvalidShape if times is below 0 or the degree would exceed kMaxDegree.
NurbsCurve elevated(const NurbsCurve& curve, int times = 1);

/// A curve of a lower degree: the one nearest in its control points, in the sum of squares, whose inner
/// knots have one copy fewer but one at least. A plain curve keeps its ends and comes back clamped.
///
/// Exact, but for rounding, where the curve was raised from such a degree.
/// @throws InvalidShape unless 1 <= times < degree; ToleranceNotReached with a tolerance (a length) that
///         the error exceeds.
Approximation<NurbsCurve> reduced(const NurbsCurve& curve, int times = 1, std::optional<double> tolerance = {});

}  // namespace splinecore
