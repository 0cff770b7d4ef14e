#include "splinecore/patch/removal.hpp"

#include <algorithm>
#include <cmath>

#include "base/as_many.hpp"
#include "base/given_points.hpp"
#include "base/require.hpp"
#include "basis/removal_rounds.hpp"
#include "basis/selection.hpp"
#include "curve/without_knot.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/patch/distance.hpp"
#include "tolerance.hpp"
#include "without_copies.hpp"

namespace splinecore {

namespace {

NurbsPatch removed(const NurbsPatch& patch, Axis axis, double u, int times) {
  return along(patch, axis, [&](const NurbsCurve& line) { return without_knot(line, u, times); });
}

}  // namespace

Approximation<NurbsPatch> remove_knot(const NurbsPatch& patch, Axis axis, double u, int times,
                                      std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  return within(tolerance, patch, removed(patch, axis, u, times), "the knot cannot be removed");
}

Approximation<NurbsPatch> without_copies(Approximation<NurbsPatch> best, Axis axis, double u,
                                         const NurbsPatch& original, double tolerance) {
  const auto without = [&](const NurbsPatch& patch, int times) -> std::optional<Approximation<NurbsPatch>> {
    try {
      Approximation<NurbsPatch> found{removed(patch, axis, u, times), 0.0};
      found.error = largest_distance(original, found.value);
      if (found.error <= tolerance) return found;
    } catch (const InvalidShape&) {
      // No copies are left that may go, or a weight falls to nearly zero and throws its point out of the range.
    }
    return std::nullopt;
  };
  return removed_as_often_as_can_be(std::move(best), without);
}

namespace {

/// The homogeneous points of a plain direction, across all its lines.
KnotList list_of(const NurbsPatch& patch, Axis axis) {
  const Lines lines = homogeneous_lines_of(patch, axis);
  const auto net = patch.homogeneous_points();
  std::vector<glm::dvec4> rows;
  rows.reserve(lines.size * lines.count);
  for (std::size_t i = 0; i < lines.size; ++i) {
    for (std::size_t line = 0; line < lines.count; ++line) rows.push_back(net[lines.at(line, i)]);
  }
  return {patch.knot_vector(axis), std::move(rows), lines.count};
}

NurbsPatch without_listed(const NurbsPatch& patch, Axis axis, std::span<const int> order) {
  KnotList list = list_of(patch, axis);
  for (const int i : order) list.remove(i);
  const KnotList::Rest rest = list.rest();
  const Lines old = lines_of(patch, axis);
  const Lines lines(axis, old.count, rest.origins.size());
  std::vector<glm::dvec4> points(rest.rows.size());
  for (std::size_t i = 0; i < lines.size; ++i) {
    for (std::size_t line = 0; line < lines.count; ++line) points[lines.at(line, i)] = rest.rows[i * lines.count + line];
  }
  GivenPoints given = as_given_from(patch, points);
  for (std::size_t i = 0; i < lines.size; ++i) {
    const int origin = rest.origins[i];
    for (std::size_t line = 0; origin >= 0 && line < lines.count; ++line) {
      given.made[lines.at(line, i)] = given.old[old.at(line, origin)];
    }
  }
  return with_axis(patch, axis, rest.knots, std::move(given.made));
}

/// How far the patch around one knot of a list moves when it goes.
double true_cost(const KnotList& list, int i, const NurbsPatch& patch, Axis axis) {
  const KnotList::Rest part = list.around_of(i);
  const Lines lines(axis, lines_of(patch, axis).count, part.origins.size());
  std::vector<glm::dvec4> points(part.rows.size());
  for (std::size_t k = 0; k < lines.size; ++k) {
    for (std::size_t line = 0; line < lines.count; ++line) points[lines.at(line, k)] = part.rows[k * lines.count + line];
  }
  try {
    const NurbsPatch before = with_axis(patch, axis, part.knots, as_given(points));
    return largest_distance(before, removed(before, axis, list.knot(i), 1));
  } catch (const InvalidShape&) {
    return HUGE_VAL;  // a part at infinity
  }
}

NurbsPatch unrolled(const NurbsPatch& patch, Axis axis) {
  return patch.knot_vector(axis).periodic() ? selected(patch, axis, unrolled(patch.knot_vector(axis))) : patch;
}

/// What unrolled() made of a periodic direction as that again: no point near its ends has changed.
NurbsPatch rolled_up(const NurbsPatch& plain, Axis axis) {
  Selection selection{rolled_up(plain.knot_vector(axis)), {}};
  for (int i = 0; i < selection.knots.count(); ++i) selection.indices.push_back(i);
  return selected(plain, axis, selection);
}

}  // namespace

Approximation<NurbsPatch> remove_knots(const NurbsPatch& patch, Axis axis, double tolerance) {
  require_tolerance(tolerance);
  const bool is_periodic = patch.knot_vector(axis).periodic();
  const auto without = [&](const NurbsPatch& some, std::span<const int> order) {
    const NurbsPatch less = without_listed(unrolled(some, axis), axis, order);
    return is_periodic ? rolled_up(less, axis) : less;
  };
  const auto list = [&](const NurbsPatch& some) { return list_of(unrolled(some, axis), axis); };
  const auto distance = [&](const NurbsPatch& some) { return largest_distance(patch, some); };
  std::vector<double> kept = is_periodic ? knots_at_seam(patch.knot_vector(axis)) : std::vector<double>{};
  const auto judge = [&](const KnotList& some, int i) { return true_cost(some, i, patch, axis); };
  Approximation<NurbsPatch> best =
      without_listed_knots<NurbsPatch>({patch, 0.0}, tolerance, std::move(kept), list, without, distance, judge);
  if (!is_periodic) return best;
  const KnotVector knots = best.value.knot_vector(axis);
  return without_knots_at_seam(std::move(best), knots, [&](Approximation<NurbsPatch> some, double u) {
    return without_copies(std::move(some), axis, u, patch, tolerance);
  });
}

}  // namespace splinecore
