#include "step_error.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace splinecore {

double error_of(const TwoPatches& patches, const SectionStep& step) {
  double most = 0.0;
  for (const double s : {0.15, 0.33, 0.5, 0.67, 0.85}) {
    const glm::dvec3 point = step.point(s);
    const PatchSpots at = step.spots(s);
    most = std::max({most, glm::length(patches.a.at(at.a, point).offset), glm::length(patches.b.at(at.b, point).offset)});
  }
  return most;
}

bool leaves_pieces(const TwoPatches& patches, const SectionStep& step, double distance) {
  for (const double s : {0.125, 0.25, 0.5, 0.75, 0.875}) {
    const PatchSpots at = step.spots(s);
    for (std::size_t i = 0; i < 4; ++i) {
      const double out = std::max(-at[i], at[i] - 1.0);
      if (out <= 0.0) continue;
      const Slopes<2> there = i < 2 ? patches.a.at(at.a) : patches.b.at(at.b);
      if (out * glm::length(there.first[i % 2]) > distance) return true;
    }
  }
  return false;
}

}  // namespace splinecore
