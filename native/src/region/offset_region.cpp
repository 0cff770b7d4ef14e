#include "splinecore/region/offset_region.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "boundary.hpp"
#include "build/offset_parts.hpp"
#include "region_plane.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/arc_length.hpp"

namespace splinecore {

Region offset(const Region& region, double distance, OffsetCorner corner, std::optional<double> tolerance) {
  if (!std::isfinite(distance)) throw InvalidShape("distance is not finite");
  if (distance == 0.0 || region.is_empty()) return region;
  const OffsetOptions options{region.normal(), tolerance, corner, true};
  std::vector<NurbsCurve> moved;
  for (const NurbsCurve& outline : region.outlines()) std::ranges::move(offset_parts(outline, -distance, options), std::back_inserter(moved));
  if (moved.empty()) return Region::of_outlines({}, region.normal());
  const double near = region_tolerance(moved, {});
  for (const NurbsCurve& curve : moved) {
    if (!is_closed(curve)) throw InvalidShape("the offset of an outline does not close: another tolerance may help");
  }
  return Region::of_outlines(wound_by(moved, [](int turns) { return turns > 0; }, region.normal(), near).loops, region.normal());
}

}  // namespace splinecore
