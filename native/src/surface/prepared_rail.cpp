#include "prepared_rail.hpp"

#include <vector>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "closes.hpp"
#include "kink.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

NurbsCurve prepared_rail(const NurbsCurve& rail, double negligible) {
  if (!closes(rail)) return clamped(rail);
  const NurbsCurve round = made_periodic(rail).value;
  const std::vector<double> corners = corners_above(round, negligible);
  return corners.empty() ? round : clamped(with_seam_at(round, corners.front()));
}

void require_upright(const SweepOptions& options) {
  if (options.frame == RailFrame::upright && !(is_finite(options.up) && length_of(options.up) > 0.0)) {
    throw InvalidShape("the upright direction is zero or not finite");
  }
}

}  // namespace splinecore
