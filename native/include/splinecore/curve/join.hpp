#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// What two curves share where one continues the other: the point; the direction, too; the first
/// derivative; the first two.
enum class Smoothness { c0, g1, c1, c2 };

/// Curve a and then curve b as one, over a's domain and then b's.
///
/// The end of a and the start of b meet in their middle. For g1 the points beside them turn into one
/// direction. For c1 and c2 the domain of b is first scaled so that both derivatives have one length, and
/// then the points next to the joint move as little as the condition asks (least squares; S7). Where the lengths
/// agree but for rounding the domain stays: parts of a split curve are that curve again. Weights stay. The error
/// is how far the curves moved. The knot at the joint has as few copies as the result allows.
/// @throws InvalidShape if a curve is periodic, an end lies at infinity, or no direction lies between the ends'.
Approximation<NurbsCurve> joined(const NurbsCurve& a, const NurbsCurve& b, Smoothness smoothness);

}  // namespace splinecore
