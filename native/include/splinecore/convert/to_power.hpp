#pragma once

#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/power_curve.hpp"

namespace splinecore {

/// The same curve in powers of t - origin, on [0, 1] (lecture row S2). Exact up to the rounding of the
/// coefficients, which cancel: relative to the points, at degree 20 it costs 1e-14 about the middle, 1e-8 about an
/// end and everything about 10; at degree 10 1e-15, 1e-12 and 1e-2.
/// @throws InvalidShape if the origin is not finite or a coefficient overflows.
PowerCurve to_power(const BezierCurve& curve, double origin = 0.0);

/// One power curve for each span of positive length, in order, about the start of its span.
/// @throws InvalidShape if a coefficient overflows, or a span lies at infinity altogether.
std::vector<PowerCurve> to_power(const NurbsCurve& curve);

}  // namespace splinecore
