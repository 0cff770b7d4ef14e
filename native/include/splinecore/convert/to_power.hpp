#pragma once

#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/power_curve.hpp"

namespace splinecore {

/// The same curve in powers of t - origin, on [0, 1] (lecture row S2). Exact up to the rounding of the
/// coefficients; these grow like 2^degree about an end and (1 + |origin|)^degree times that about a far
/// origin, so that at degree 20 about an end six digits are lost, and at degree 50 nearly all.
/// @throws InvalidShape if the origin is not finite or a coefficient overflows.
PowerCurve to_power(const BezierCurve& curve, double origin = 0.0);

/// One power curve for each span of positive length, in order, about the start of its span.
/// @throws InvalidShape if a coefficient overflows, or a span lies at infinity altogether.
std::vector<PowerCurve> to_power(const NurbsCurve& curve);

}  // namespace splinecore
