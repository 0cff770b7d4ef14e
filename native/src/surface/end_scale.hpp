#pragma once

#include <array>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The linear function over [0, 1] by which the weights of a clamped curve are 1 at both ends.
struct EndScale {
  double start;
  double end;

  /// Of a curve without an end at infinity.
  static EndScale of(const NurbsCurve& curve);

  /// Up to rounding.
  bool is_level() const;
  double at(double s) const { return is_level() ? start : (1.0 - s) * start + s * end; }
};

/// The derivative by s, at both ends, of weights that are scaled so.
std::array<double, 2> scaled_weight_slopes(const NurbsCurve& curve);

}  // namespace splinecore
#pragma GCC visibility pop
