#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "least_squares_fit.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/fit/rebuild.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How many control points at the ends of a direction stay: of one that is not clamped as many as decide its ends.
Held held_of(const KnotVector& knots, KeptEnds ends);

/// An exponent between two at which errors are below and above a tolerance, by how these run in between; away from both, so that
/// the stretch between them shrinks from either end.
inline double exponent_between(const Interval& between, const std::array<double, 2>& errors, double tolerance) {
  constexpr double kAway = 0x1p-4;
  const double rise = std::log(errors[1] / errors[0]);
  const double share = rise > 0.0 ? std::log(tolerance / errors[0]) / rise : 0.5;
  return between.start + between.length() * std::clamp(share - 0.5 * kAway, kAway, 1.0 - kAway);
}

/// What is faired with the largest multiple of the energy that the tolerance allows: by halving, and then by how the error grows,
/// until it is as large as the tolerance but for 2^-10 of it. A motion, which changes errors by rounding, changes no more than that.
/// @param same    what is faired, as it is
/// @param faired  of the exponent of a multiple: nothing where numbers cannot tell
/// @returns nothing where numbers cannot tell of any multiple that is small enough
template <class Shape, class Faired>
std::optional<Approximation<Shape>> fairest(const Shape& same, double tolerance, const Faired& faired) {
  constexpr double kWeakest = -70.0;
  constexpr double kStrongest = 10.0;
  constexpr double kNear = 0.125;
  constexpr double kAsLarge = 1.0 - 0x1p-10;
  constexpr int kMostRounds = 12;
  Approximation<Shape> best{same, 0.0};
  double low = kWeakest;
  double high = kStrongest + kNear;
  double error_above = 0.0;  // of high; 0 where that was not tried, or has no solution
  bool is_told = true;       // the weakest multiple that was tried has a solution
  const auto look = [&](double exponent) {
    std::optional<Approximation<Shape>> made = faired(exponent);
    const bool has_solution = made.has_value();
    if (has_solution && made->error <= tolerance) {
      best = *std::move(made);
      low = exponent;
      return;
    }
    high = exponent;
    error_above = has_solution ? made->error : 0.0;
    is_told = has_solution;
  };
  for (double middle = kStrongest; high - low > kNear; middle = 0.5 * (low + high)) look(middle);
  for (int round = 0; round < kMostRounds && error_above > 0.0 && best.error > 0.0; ++round) {
    if (best.error >= kAsLarge * tolerance) break;
    look(exponent_between({low, high}, {best.error, error_above}, tolerance));
  }
  if (low > kWeakest || is_told) return best;
  return {};
}

}  // namespace splinecore
#pragma GCC visibility pop
