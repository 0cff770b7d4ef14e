#include "rebuild_together.hpp"

#include <algorithm>

#include "fit/rebuilt_on.hpp"
#include "fitted_together.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

Approximation<std::vector<NurbsCurve>> rebuild_together(std::span<const NurbsCurve> curves, int degree, double tolerance) {
  if (curves.empty()) throw InvalidShape("there is no curve");
  const Interval domain = curves[0].domain();
  const bool is_periodic = std::ranges::all_of(curves, &NurbsCurve::periodic);
  std::vector<NurbsCurve> given;
  for (const NurbsCurve& curve : curves) {
    const NurbsCurve whole = is_periodic ? curve : clamped(curve);
    given.push_back(whole.domain() == domain ? whole : with_domain(whole, domain));
  }
  return fitted_together({given.size(), degree, domain, is_periodic, corners_of(given), tolerance},
                         [&](std::size_t i, const KnotVector& knots) { return rebuilt_on(given[i], knots, KeptEnds::points); });
}

}  // namespace splinecore
