#include "rebuild_together.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "fit/rebuilt_on.hpp"
#include "fitted_together.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

using Curves = Approximation<std::vector<NurbsCurve>>;

/// Creases of curves that need at least so many copies of a knot.
std::vector<Crease> creases_of_all(std::span<const NurbsCurve> curves, int degree, int least) {
  std::vector<Crease> found;
  for (const NurbsCurve& curve : curves) {
    for (const Crease& one : creases_of(curve, degree)) {
      if (one.times >= least) found.push_back(one);
    }
  }
  return found;
}

Curves rebuilt_with(const FitTogether& what, std::span<const NurbsCurve> given) {
  return fitted_together(what, [&](std::size_t i, const KnotVector& knots) { return rebuilt_on(given[i], knots, KeptEnds::points); });
}

std::size_t knots_in(const Curves& curves) { return curves.value[0].knot_vector().knots().size(); }

}  // namespace

// Knots gather about creases by themselves; where they are sharp, or few, knots at them are fewer.
Approximation<std::vector<NurbsCurve>> rebuild_together(std::span<const NurbsCurve> curves, int degree, double tolerance) {
  if (curves.empty()) throw InvalidShape("there is no curve");
  const Interval domain = curves[0].domain();
  const bool is_periodic = std::ranges::all_of(curves, &NurbsCurve::periodic);
  std::vector<NurbsCurve> given;
  for (const NurbsCurve& curve : curves) {
    const NurbsCurve whole = is_periodic ? curve : clamped(curve);
    given.push_back(whole.domain() == domain ? whole : with_domain(whole, domain));
  }
  FitTogether what{given.size(), degree, domain, is_periodic, corners_of(given), tolerance};
  std::optional<Curves> best;
  std::optional<ToleranceNotReached> missed;
  for (int least = degree; least > 0; --least) {
    auto creases = creases_of_all(given, degree, least);
    if (least < degree && creases.size() == what.creases.size()) continue;
    what.creases = std::move(creases);
    try {
      Curves made = rebuilt_with(what, given);
      if (!best || knots_in(made) < knots_in(*best)) best = std::move(made);
    } catch (const ToleranceNotReached& error) {
      missed = error;
    }
  }
  if (!best) throw ToleranceNotReached(*missed);
  return std::move(*best);
}

}  // namespace splinecore
