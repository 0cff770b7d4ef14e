#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "knot_removal.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The best after the first removals of a list that leave the distance within the tolerance, and how many these are:
/// mostly all.
/// @param without   (shape, knots of its list) -> shape
/// @param distance  of a shape from what it stands for
template <class Shape, class Without, class Distance>
std::pair<Approximation<Shape>, std::size_t> as_far_as_it_goes(const Approximation<Shape>& best,
                                                               const std::vector<int>& order, double tolerance,
                                                               Without without, Distance distance) {
  using Best = Approximation<Shape>;
  const auto after = [&](std::size_t count) -> std::optional<Best> {
    try {
      Shape less = without(best.value, std::span(order).first(count));
      const double error = distance(less);
      if (error <= tolerance) return Best{std::move(less), error};
    } catch (const InvalidShape&) {
      // A weight that falls to nearly zero throws its point out of the range of numbers.
    }
    return std::nullopt;
  };
  if (auto all = after(order.size())) return {std::move(*all), order.size()};
  std::pair<Best, std::size_t> found{best, 0};
  for (std::size_t high = order.size(); high - found.second > 1;) {
    const std::size_t middle = found.second + (high - found.second) / 2;
    if (auto next = after(middle)) {
      found = {std::move(*next), middle};
    } else {
      high = middle;
    }
  }
  return found;
}

/// The best without the knots that can go, least error first. Costs add up to more than the truth: as long as something
/// is left of the tolerance more may go.
/// @param list_of  shape -> KnotList
/// @param kept     knots that stay, in order
/// @param judge    as of removal_order()
template <class Shape, class ListOf, class Without, class Distance>
Approximation<Shape> without_listed_knots(Approximation<Shape> best, double tolerance, std::vector<double> kept,
                                          ListOf list_of, Without without, Distance distance, const Judge& judge) {
  constexpr int kMostRounds = 16;
  for (int round = 0; round < kMostRounds; ++round) {
    const KnotList list = list_of(best.value);
    const std::vector<int> order = removal_order(list, tolerance, kept, judge);
    if (order.empty()) break;
    auto [next, count] = as_far_as_it_goes(best, order, tolerance, without, distance);
    if (count < order.size()) {
      const double knot = list.knot(order[count]);
      kept.insert(std::ranges::upper_bound(kept, knot), knot);
    }
    best = std::move(next);
  }
  return best;
}

/// The knots of a periodic vector whose points lie on both sides of its seam, in order.
inline std::vector<double> knots_at_seam(const KnotVector& knots) {
  const auto all = knots.unrolled();
  const auto margin = std::min(std::ptrdiff_t{2} * knots.degree() + 1, std::ssize(all));
  std::vector<double> found(all.begin(), all.begin() + margin);
  found.insert(found.end(), all.end() - margin, all.end());
  std::ranges::sort(found);
  return found;
}

/// The best of a periodic shape after all copies are gone that can go of the knots at its seam, which no list has.
/// @param knots    the vector of the best
/// @param without  (best, u) -> the best without copies of u
template <class Shape, class Without>
Approximation<Shape> without_knots_at_seam(Approximation<Shape> best, const KnotVector& knots, Without without) {
  const Interval domain = knots.domain();
  std::vector<double> at_seam = knots_at_seam(knots);
  std::erase_if(at_seam, [&](double u) { return u < domain.start || u >= domain.end; });
  at_seam.erase(std::ranges::unique(at_seam).begin(), at_seam.end());
  for (const double u : at_seam) best = without(std::move(best), u);
  return best;
}

/// The period of what unrolled() made of a periodic vector, when no knot near its ends has changed.
inline KnotVector rolled_up(const KnotVector& plain) {
  const auto knots = plain.knots();
  const int degree = plain.degree();
  return KnotVector::make(degree, {knots.begin() + degree, knots.end() - degree}, true);
}

}  // namespace splinecore
#pragma GCC visibility pop
