#pragma once

#include <functional>

#include "speed.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of a curve whose length one rule finds. Lengths are divided by 2^exponent.
struct LengthPart {
  const SpeedPiece& speed;
  const Speed& rule;
  double length;
  double before;  ///< the length of the curve before it
  int exponent;
  Interval span;
  Interval part;  ///< of the span, which is [0, 1]
};

/// Called for each part, in order.
using VisitPart = std::function<void(const LengthPart&)>;

/// The length of the curve on a part of its domain, as length().
Approximation<double> length_by_parts(const NurbsCurve& curve, const Interval& range, double tolerance,
                                      const VisitPart& visit = {});

}  // namespace splinecore
#pragma GCC visibility pop
