#include <limits>

#include "base/require.hpp"
#include "patch_places.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/meet/stationary.hpp"

namespace splinecore {

namespace {

std::vector<StationaryOnPatch> places_within(const NurbsPatch& patch, const glm::dvec3& point, double limit) {
  const NearPatch near(patch, point);
  PatchPlaces places(near, limit);
  add_poles(places);
  add_inner_places(places);
  add_outer_places(places);
  return places.found();
}

}  // namespace

std::vector<StationaryOnPatch> stationary_points(const NurbsPatch& patch, const glm::dvec3& point) {
  return places_within(patch, point, std::numeric_limits<double>::infinity());
}

std::vector<NearestOnPatch> nearest_all(const NurbsPatch& patch, const glm::dvec3& point,
                                        std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  require_finite({&point.x, 3}, "point");
  NearestOnPatch least;
  nearest(patch, {&point, 1}, {&least, 1}, 1);
  const double limit = limit_of(least.distance, tolerance, patch.points());
  std::vector<NearestOnPatch> found;
  for (const StationaryOnPatch& place : places_within(patch, point, limit)) {
    if (place.kind != Stationary::minimum || place.distance > limit) continue;
    found.push_back({place.u, place.v, place.point, place.distance});
  }
  return found.empty() ? std::vector{least} : found;
}

}  // namespace splinecore
