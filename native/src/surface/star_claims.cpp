#include "star_claims.hpp"

namespace splinecore {

StarClaims::StarClaims(const Star& star) : star_(star), claims_(star.size()) {}

void StarClaims::add(std::size_t patch, std::size_t i, std::size_t j, const glm::dvec3& point, int rank) {
  Claim& claim = claims_[star_.at(patch, i, j)];
  if (claim.count > 0 && rank > claim.rank) return;
  if (claim.count > 0 && rank < claim.rank) claim = {};
  claim.sum += point;
  claim.rank = rank;
  ++claim.count;
}

std::vector<std::optional<glm::dvec3>> StarClaims::points() const {
  std::vector<std::optional<glm::dvec3>> found;
  for (const Claim& claim : claims_) {
    found.push_back(claim.count == 0 ? std::nullopt : std::optional(claim.sum / static_cast<double>(claim.count)));
  }
  return found;
}

}  // namespace splinecore
