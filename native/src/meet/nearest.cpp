#include "splinecore/meet/nearest.hpp"

#include "base/parallel.hpp"
#include "base/require.hpp"
#include "nearest_places.hpp"

namespace splinecore {

namespace {

template <int kAxes, class Shape, class Place>
void search_all(const Shape& shape, std::span<const glm::dvec3> points, std::span<Place> out, int threads) {
  constexpr std::size_t kSteps = kAxes == 1 ? 512 : 4096;
  const BoxedPieces& pieces = boxed_pieces(shape);
  require_finite(points, "points");
  in_ranges(points.size(), kSteps, threads, [&](std::size_t begin, std::size_t end) {
    NearestSearch<kAxes> search(pieces);
    for (std::size_t i = begin; i < end; ++i) {
      const NearPoint near = pieces.space().enter(points[i]);
      const NearestPlace place = search.nearest(near.at);
      if (!place.found()) throw PointAtInfinity("no point of the shape is finite");
      out[i] = on_shape(shape, pieces.space(), place, distance_to(place, near, points[i], i, pieces.space()));
    }
  });
}

}  // namespace

void nearest(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<NearestOnCurve> out,
             int threads) {
  search_all<1>(curve, points, out, threads);
}

void nearest(const NurbsPatch& patch, std::span<const glm::dvec3> points, std::span<NearestOnPatch> out,
             int threads) {
  search_all<2>(patch, points, out, threads);
}

}  // namespace splinecore
