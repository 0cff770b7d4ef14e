#include "splinecore/patch/removal.hpp"

#include <algorithm>

#include "lines.hpp"
#include "splinecore/base/as_many.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/patch/distance.hpp"
#include "tolerance.hpp"

namespace splinecore {

namespace {

NurbsPatch removed(const NurbsPatch& patch, Axis axis, double u, int times) {
  return along(patch, axis, [&](const NurbsCurve& line) { return without_knot(line, u, times); });
}

}  // namespace

Approximation<NurbsPatch> remove_knot(const NurbsPatch& patch, Axis axis, double u, int times,
                                      std::optional<double> tolerance) {
  require_tolerance(tolerance);
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

Approximation<NurbsPatch> remove_knots(const NurbsPatch& patch, Axis axis, double tolerance) {
  require_tolerance(tolerance);
  Approximation<NurbsPatch> best{patch, 0.0};
  const auto knots = patch.knot_vector(axis).knots();
  std::vector<double> distinct(knots.begin(), knots.end());
  distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
  if (patch.knot_vector(axis).periodic()) distinct.pop_back();
  for (const double u : distinct) best = without_copies(std::move(best), axis, u, patch, tolerance);
  return best;
}

}  // namespace splinecore
