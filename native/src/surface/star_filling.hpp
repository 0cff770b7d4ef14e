#pragma once

#include <optional>
#include <vector>

#include "hole.hpp"
#include "hole_guide.hpp"
#include "star.hpp"
#include "star_rows.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Patches that fill a hole, and what of their control points its sides decide.
struct ClaimedStar {
  Star star;
  std::vector<std::optional<glm::dvec3>> points;

  /// With the others at the origin.
  std::vector<NurbsPatch> patches() const;
};

ClaimedStar claimed_star(const Hole& hole, std::vector<KnotPair> knots);

/// With the others where patches bend least, but for what is expected of them.
/// @param guide  what is expected, if any
std::vector<NurbsPatch> solved(const Hole& hole, const ClaimedStar& claimed, const HoleGuide* guide);

}  // namespace splinecore
#pragma GCC visibility pop
