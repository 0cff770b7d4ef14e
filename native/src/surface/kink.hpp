#pragma once

#include <optional>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a kink that is smoothed over may take of a tolerance.
inline constexpr double kKinkShare = 0.1;

/// How far a curve's way turns at a parameter; of a periodic one also at its seam.
double kink_angle(const NurbsCurve& curve, double u);

/// Corners of a curve at which it turns by more than an angle.
std::vector<double> corners_above(const NurbsCurve& curve, double angle);

/// A knot beside which the curve turns by more than an angle within fewer numbers than a spline can be parted between.
std::optional<double> hidden_turn(const NurbsCurve& curve, double angle);

}  // namespace splinecore
#pragma GCC visibility pop
