#include "moment_integral.hpp"

#include <glm/geometric.hpp>
#include <span>

#include "surface_nodes.hpp"

namespace splinecore {

namespace {

Integrands<kMoments> integrands_at(const SurfacePlace& place) {
  const glm::dvec3& s = place.point;
  const double flux = glm::dot(s, glm::cross(place.along_u, place.along_v));
  const double far = glm::length(s);
  const double size = far * glm::length(place.along_u) * glm::length(place.along_v);
  Integrands<kMoments> found{{flux / 3.0}, {size / 3.0}};
  std::size_t at = 4;
  for (int i = 0; i < 3; ++i) {
    found.values[1 + i] = s[i] * flux / 4.0;
    found.terms[1 + i] = far * size / 4.0;
    for (int j = i; j < 3; ++j, ++at) {
      found.values[at] = s[i] * s[j] * flux / 5.0;
      found.terms[at] = far * far * size / 5.0;
    }
  }
  return found;
}

}  // namespace

FoundMoments moments_of(const std::vector<NurbsPatch>& patches, const MomentTargets& targets, const char* what) {
  std::vector<SurfaceNodes> nodes = nodes_of(patches);
  AdaptivePieces<kMoments> adaptive(what, [&](std::span<MeasuredPiece<kMoments>> pieces) {
    for (auto& [piece, patch, found] : pieces) {
      found = grid_sums<kMoments>([&](std::size_t i, std::size_t j) {
        return integrands_at(nodes[patch].at(piece.net, i, j));
      });
    }
  });
  for (const NurbsPatch& patch : patches) adaptive.add(patch);
  return adaptive.found(targets);
}

}  // namespace splinecore
