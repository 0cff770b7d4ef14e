#pragma once

#include "basis/scaled_knots.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Powers of two near the largest coordinate and weight, and near the length of the domain.
struct Scales {
  int coordinates = 0;
  int weights = 0;
  int parameters = 0;
};

/// None that would take another number of the curve out of the range of numbers.
Scales scales_of(const NurbsCurve& curve);

/// Those that two curves can share, all but the weights, which are a's.
Scales shared_scales(const NurbsCurve& a, const NurbsCurve& b);

/// The curve with coordinates, weights and knots divided by these powers of two: to the digit, and of a
/// size that products of a few numbers stay in range.
NurbsCurve divided(const NurbsCurve& curve, const Scales& scales);

/// The power of two near the length of the domain, 0 where products of a few numbers stay in range as it is; none that
/// would take a knot out of the range of numbers.
int scale_of(const KnotVector& knots);

/// The knots divided by a power of two.
KnotVector divided(const KnotVector& knots, int exponent);

/// The knots divided by their scale_of(): worked out once for all copies.
ScaledKnots near_one(const KnotVector& knots);

}  // namespace splinecore
#pragma GCC visibility pop
