#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Curves that follow one another round a hole, clamped, each turned so that it begins where the one before it ends; the
/// first as it is, if the second begins or ends at its end.
/// @param tolerance  none: 2^-30 of the size of the curves
/// @returns the curves with both ends that meet in their middle, and how far an end was moved
/// @throws InvalidShape if a curve is closed or ends at infinity; ToleranceNotReached naming the curves that do not meet
Approximation<std::vector<NurbsCurve>> border_loop(std::span<const NurbsCurve> curves, std::optional<double> tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
