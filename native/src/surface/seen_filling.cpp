#include "seen_filling.hpp"

#include <algorithm>
#include <cstddef>

#include "base/length.hpp"
#include "measure/seam_angle.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/seam.hpp"

namespace splinecore {

namespace {

double gap_along(const HoleSide& side, const PartOfSide& part, const NurbsPatch& patch) {
  constexpr int kPlaces = 129;
  std::vector<double> at;
  std::vector<double> s;
  for (int k = 0; k < kPlaces; ++k) {
    at.push_back(static_cast<double>(k) / (kPlaces - 1));
    s.push_back(part.from + (part.to - part.from) * at.back());
  }
  const NurbsCurve border = boundary(patch, part.border);
  std::vector<glm::dvec3> points(kPlaces);
  evaluate(border, at, std::span(&points.front().x, 3 * points.size()));
  const std::vector<glm::dvec3> wanted = side.points(s);
  double largest = 0.0;
  for (int k = 0; k < kPlaces; ++k) largest = std::max(largest, distance_of(points[k], wanted[k]));
  return largest;
}

}  // namespace

Filling seen_along_sides(const Hole& hole, const std::vector<PartOfSide>& parts, const std::vector<NurbsPatch>& patches,
                         const std::optional<FillLimits>& limits) {
  Filling filling;
  for (const PartOfSide& part : parts) {
    filling.gap = std::max(filling.gap, gap_along(hole.sides[part.side], part, patches[part.patch]));
  }
  for (const PartOfSide& part : parts) {
    if (limits && !limits->are_met(filling)) return filling;
    const HoleSide& side = hole.sides[part.side];
    const NurbsPatch& patch = patches[part.patch];
    if (side.continuity() == 0) continue;
    const auto [low, high] = std::minmax(part.from, part.to);
    const NurbsPatch neighbour = *side.neighbour_part(low, high);
    const bool is_reversed = part.from > part.to;
    if (side.continuity() == 1) {
      filling.angle = std::max(filling.angle, seam_angle(patch, part.border, neighbour, Border::v_end, is_reversed));
      continue;
    }
    const SeamContinuity seam =
        seam_continuity(patch, part.border, neighbour, Border::v_end, kContinuityTolerance, {}, is_reversed);
    filling.angle = std::max(filling.angle, seam.angle);
    filling.curvature_difference = std::max(filling.curvature_difference, seam.curvature_difference);
  }
  return filling;
}

double angle_between_patches(const std::vector<NurbsPatch>& patches, Border next) {
  double largest = 0.0;
  for (std::size_t k = 0; k < patches.size() && patches.size() > 1; ++k) {
    largest = std::max(largest, seam_angle(patches[k], Border::u_end, patches[(k + 1) % patches.size()], next, false));
  }
  return largest;
}

}  // namespace splinecore
