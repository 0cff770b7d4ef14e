#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Curves that follow one another round a hole, clamped, each turned so that it begins where the one before it ends.
struct BorderLoop {
  std::vector<NurbsCurve> curves;  ///< with both ends that meet in their middle
  std::vector<bool> is_turned;
  double tolerance;
  double error;                    ///< how far an end was moved
};

/// The first as it is, if the second begins or ends at its end.
/// @param tolerance  none: 2^-30 of the size of the curves
/// @throws InvalidShape if a curve is closed or ends at infinity; ToleranceNotReached naming the curves that do not meet
BorderLoop border_loop(std::span<const NurbsCurve> curves, std::optional<double> tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
