#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// The same curve with a degree higher by `times`; its end points keep every digit (The NURBS Book, eq. 5.36;
/// lecture row S6). @throws InvalidShape if times is below 0 or the degree would exceed kMaxDegree.
BezierCurve elevated(const BezierCurve& curve, int times = 1);

/// A curve with a degree lower by `times` and the same ends.
///
/// Each step takes the nearest such curve in the maximum norm, by subtracting the constrained Chebyshev
/// polynomial, which vanishes at both ends, times the leading coefficient (Lachance 1988; row S6). Of one
/// step on a polynomial curve the error is exact; of more, or of a rational one, where homogeneous points
/// are approximated, it is an upper bound.
/// @throws InvalidShape unless 1 <= times < degree, and where the weights have not one sign: then no bound holds.
Approximation<BezierCurve> reduced(const BezierCurve& curve, int times = 1);

/// reduced(), if the error is at most `tolerance`. @throws ToleranceNotReached
Approximation<BezierCurve> reduced(const BezierCurve& curve, int times, double tolerance);

}  // namespace splinecore
