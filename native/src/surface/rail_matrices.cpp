#include "splinecore/surface/rail_matrices.hpp"

#include "kink.hpp"
#include "meet/near_space.hpp"
#include "prepared_rail.hpp"
#include "rail_frames.hpp"

namespace splinecore {

namespace {

/// Parameters of a closed rail that begins elsewhere now.
std::vector<double> within(const Interval& domain, std::span<const double> at) {
  std::vector<double> places(at.begin(), at.end());
  for (double& place : places) {
    if (place < domain.start) place += domain.length();
  }
  return places;
}

}  // namespace

std::vector<glm::dmat4> rail_matrices(const NurbsCurve& rail, std::span<const double> at, const SweepOptions& options) {
  require_upright(options);
  const NearSpace space(rail.points());
  const NurbsCurve whole = prepared_rail(rail, kKinkShare * 0x1p-20);
  const NurbsCurve near = whole.with_points(space.enter(whole.points()));
  const double start = near.domain().start;
  RailPlaces along(near, options);
  const MovingFrame first = along.at(std::span(&start, 1), near.domain())[0].frame;
  std::vector<glm::dmat4> matrices;
  for (RailPlace& place : along.at(within(near.domain(), at), near.domain())) {
    if (options.frame == RailFrame::parallel) place.frame = first;
    matrices.push_back(matrix_of(place, space));
  }
  return matrices;
}

}  // namespace splinecore
