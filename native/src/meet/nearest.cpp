#include "splinecore/meet/nearest.hpp"

#include <cmath>
#include <string>

#include "base/length.hpp"
#include "base/parallel.hpp"
#include "base/require.hpp"
#include "nearest_search.hpp"
#include "splinecore/base/errors.hpp"
#include "within_period.hpp"

namespace splinecore {

namespace {

double distance_to(const NearestPlace& place, const NearPoint& near, const glm::dvec3& point, std::size_t i,
                   const NearSpace& space) {
  const double distance =
      near.moved ? distance_of(point, space.leave(place.point)) : space.length(std::sqrt(place.squared));
  if (std::isfinite(distance)) return distance;
  throw InvalidShape("points" + index_text(i) + " is too far away: its distance is too large for a number");
}

/// Calls write(i, place, distance) for each point.
template <int kAxes, class Write>
void search_all(const BoxedPieces& pieces, std::span<const glm::dvec3> points, int threads, Write write) {
  constexpr std::size_t kSteps = kAxes == 1 ? 512 : 4096;
  require_finite(points, "points");
  in_ranges(points.size(), kSteps, threads, [&](std::size_t begin, std::size_t end) {
    NearestSearch<kAxes> search(pieces);
    for (std::size_t i = begin; i < end; ++i) {
      const NearPoint near = pieces.space().enter(points[i]);
      const NearestPlace place = search.nearest(near.at);
      if (!place.found()) throw PointAtInfinity("no point of the shape is finite");
      write(i, place, distance_to(place, near, points[i], i, pieces.space()));
    }
  });
}

}  // namespace

void nearest(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<NearestOnCurve> out,
             int threads) {
  const BoxedPieces& pieces = boxed_pieces(curve);
  search_all<1>(pieces, points, threads, [&](std::size_t i, const NearestPlace& place, double distance) {
    out[i] = {within_period(place.parameters[0], curve.knot_vector()), pieces.space().leave(place.point), distance};
  });
}

void nearest(const NurbsPatch& patch, std::span<const glm::dvec3> points, std::span<NearestOnPatch> out,
             int threads) {
  const BoxedPieces& pieces = boxed_pieces(patch);
  search_all<2>(pieces, points, threads, [&](std::size_t i, const NearestPlace& place, double distance) {
    out[i] = {within_period(place.parameters[0], patch.knot_vector(Axis::u)),
              within_period(place.parameters[1], patch.knot_vector(Axis::v)), pieces.space().leave(place.point),
              distance};
  });
}

}  // namespace splinecore
