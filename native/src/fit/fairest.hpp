#pragma once

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

/// What is faired with the largest multiple of the energy that the tolerance allows, by halving.
/// @param same    what is faired, as it is
/// @param faired  of the exponent of a multiple that is a power of two: nothing where numbers cannot tell
/// @returns nothing where numbers cannot tell of any multiple that is small enough
template <class Shape, class Faired>
std::optional<Approximation<Shape>> fairest(const Shape& same, double tolerance, const Faired& faired) {
  constexpr double kWeakest = -70.0;
  constexpr double kStrongest = 10.0;
  constexpr double kNear = 0.125;
  Approximation<Shape> best{same, 0.0};
  double low = kWeakest;
  double high = kStrongest + kNear;
  bool is_told = true;  // the weakest multiple that was tried has a solution
  for (double middle = kStrongest; high - low > kNear; middle = 0.5 * (low + high)) {
    std::optional<Approximation<Shape>> made = faired(middle);
    const bool has_solution = made.has_value();
    if (has_solution && made->error <= tolerance) {
      best = *std::move(made);
      low = middle;
    } else {
      high = middle;
      is_told = has_solution;
    }
  }
  if (low > kWeakest || is_told) return best;
  return {};
}

}  // namespace splinecore
#pragma GCC visibility pop
