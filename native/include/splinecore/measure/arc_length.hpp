#pragma once

#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// To which part of the curve's length places along it are found unless asked otherwise.
inline constexpr double kPlaceTolerance = 1e-10;

/// For each length the parameter to which the curve has it, from the start of its domain on (S15). A periodic curve
/// continues: there lengths may be any numbers, turns are counted, and so are the parameters.
///
/// One pass adds up the parts of length() for all of them; in its part each is found by Newton's iteration, whose steps
/// are halves of the bracket where they would leave it. Where the derivative is zero over an interval it is the first parameter.
/// @param tolerance  The length up to the parameter is off by at most so much of that of the curve, or by what the last
///                   digit of the parameter is worth there.
/// @throws InvalidShape naming a length that is not finite, below 0 or above that of a plain curve, or if a periodic
///         curve has none; and as length().
std::vector<double> parameters_at_lengths(const NurbsCurve& curve, std::span<const double> lengths,
                                          double tolerance = kPlaceTolerance);

/// The lengths from the start of the domain to parameters of it; the inverse.
/// @throws as length(), InvalidShape for a parameter outside the domain of a plain curve.
std::vector<double> lengths_at_parameters(const NurbsCurve& curve, std::span<const double> parameters,
                                          double tolerance = kPlaceTolerance);

/// The parameters of `count` parts of equal length: both ends of each, or where the curve closes without its end,
/// which is the start.
/// @throws InvalidShape unless 1 <= count <= 2^22, or if the curve has no length; and as length().
std::vector<double> divide(const NurbsCurve& curve, int count, double tolerance = kPlaceTolerance);

/// The parameters at 0, step, 2 step, … up to the length of the curve; where it closes without the end.
/// @throws InvalidShape unless step is positive, or if those are more than 2^22; and as length().
std::vector<double> divide_by_length(const NurbsCurve& curve, double step, double tolerance = kPlaceTolerance);

/// Whether the curve is in one piece and ends where it starts.
bool is_closed(const NurbsCurve& curve);

}  // namespace splinecore
