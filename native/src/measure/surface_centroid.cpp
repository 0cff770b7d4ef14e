#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "adaptive_pieces.hpp"
#include "base/placement.hpp"
#include "closed_set.hpp"
#include "finite_weights.hpp"
#include "placed_patches.hpp"
#include "quadrature.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/moments.hpp"
#include "surface_nodes.hpp"

namespace splinecore {

namespace {

constexpr const char* kWhat = "the centroid of the surface cannot be found";

/// The area and its first moments.
constexpr std::size_t kFirst = 4;

Integrands<kFirst> integrands_at(const SurfacePlace& place) {
  const double area = glm::length(glm::cross(place.along_u, place.along_v));
  const double size = glm::length(place.along_u) * glm::length(place.along_v);
  const double far = glm::length(place.point);
  return {{area, place.point.x * area, place.point.y * area, place.point.z * area},
          {size, far * size, far * size, far * size}};
}

FoundIntegrals<kFirst> first_moments(const std::vector<NurbsPatch>& patches, double radius, double tolerance) {
  std::vector<SurfaceNodes> nodes = nodes_of(patches);
  AdaptivePieces<kFirst> adaptive(kWhat, [&](std::span<MeasuredPiece<kFirst>> pieces) {
    for (auto& [piece, patch, found] : pieces) {
      found = grid_sums<kFirst>([&](std::size_t i, std::size_t j) {
        return integrands_at(nodes[patch].at(piece.net, i, j));
      });
    }
  });
  for (const NurbsPatch& patch : patches) adaptive.add(patch);
  return adaptive.found([&](const IntegralSums<kFirst>& sums) {
    const double allowed = 0.25 * tolerance * sums.values[0];
    return Integrals<kFirst>{allowed, radius * allowed, radius * allowed, radius * allowed};
  });
}

Approximation<glm::dvec3> centroid_of(std::span<const NurbsPatch* const> patches, std::span<const glm::dvec4> points,
                                      double tolerance) {
  for (const NurbsPatch* patch : patches) require_finite_points(*patch);
  const Placement placement = placement_of(points);
  const double radius = radius_of(points, placement);
  const auto [sums, excess] = first_moments(placed_patches(patches, placement), radius, tolerance);
  const double area = sums.values[0];
  if (!(area > sums.error(0) + 4.0 * sums.rounding(0))) {
    throw InvalidShape("the surface has no area, and so no centroid");
  }
  if (excess > 1.0) {
    const double allowed = given_size(tolerance * radius, 1, placement);
    throw ToleranceNotReached(kWhat, allowed, allowed * excess);
  }
  glm::dvec3 middle;
  glm::dvec3 wrong;
  const auto error = [&](std::size_t k) { return sums.error(k) + sums.rounding(k); };
  for (int i = 0; i < 3; ++i) {
    middle[i] = sums.values[1 + i] / area;
    wrong[i] = (error(1 + i) + std::abs(middle[i]) * error(0)) / area;
  }
  return {given_point(middle, placement), given_size(glm::length(wrong), 1, placement)};
}

}  // namespace

Approximation<glm::dvec3> surface_centroid(const NurbsPatch& patch, double tolerance) {
  require_relative(tolerance);
  const NurbsPatch* one = &patch;
  return centroid_of({&one, 1}, patch.points(), tolerance);
}

Approximation<glm::dvec3> surface_centroid(const PatchSet& set, double tolerance) {
  require_relative(tolerance);
  return centroid_of(patches_of(set), set.points(), tolerance);
}

}  // namespace splinecore
