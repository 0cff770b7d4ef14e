#include "splinecore/patch/removal.hpp"

#include <algorithm>

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/removal.hpp"
#include "splinecore/patch/distance.hpp"
#include "tolerance.hpp"

namespace splinecore {

namespace {

NurbsPatch removed(const NurbsPatch& patch, Axis axis, double u, int times) {
  return along(patch, axis, [&](const NurbsCurve& line) { return remove_knot(line, u, times).value; });
}

}  // namespace

Approximation<NurbsPatch> remove_knot(const NurbsPatch& patch, Axis axis, double u, int times,
                                      std::optional<double> tolerance) {
  require_tolerance(tolerance);
  return within(tolerance, patch, removed(patch, axis, u, times), "the knot cannot be removed");
}

std::optional<Approximation<NurbsPatch>> removed_within(const NurbsPatch& patch, Axis axis, double u,
                                                        const NurbsPatch& original, double tolerance) {
  try {
    Approximation<NurbsPatch> found{removed(patch, axis, u, 1), 0.0};
    found.error = largest_distance(original, found.value);
    if (found.error <= tolerance) return found;
  } catch (const InvalidShape&) {
    // No copy is left that may go, or a weight falls to nearly zero and throws its point out of the range of numbers.
  }
  return std::nullopt;
}

Approximation<NurbsPatch> remove_knots(const NurbsPatch& patch, Axis axis, double tolerance) {
  require_tolerance(tolerance);
  Approximation<NurbsPatch> best{patch, 0.0};
  const auto knots = patch.knot_vector(axis).knots();
  std::vector<double> distinct(knots.begin(), knots.end());
  distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
  if (patch.knot_vector(axis).periodic()) distinct.pop_back();
  for (const double u : distinct) {
    while (auto next = removed_within(best.value, axis, u, patch, tolerance)) best = std::move(*next);
  }
  return best;
}

}  // namespace splinecore
