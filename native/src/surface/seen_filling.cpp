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

/// The stretch of a part that has one neighbour, and the patch along it.
struct SeenStretch {
  double from;
  double to;
  NurbsPatch patch;
};

/// A part cut where pieces of the side meet.
std::vector<SeenStretch> stretches_of(const HoleSide& side, const PartOfSide& part, const NurbsPatch& patch) {
  const Axis along = axis_of(part.border) == Axis::u ? Axis::v : Axis::u;
  const auto [low, high] = std::minmax(part.from, part.to);
  std::vector<double> cuts;
  for (const double joint : side.joints()) {
    if (joint > low && joint < high) cuts.push_back(joint);
  }
  if (part.from > part.to) std::ranges::reverse(cuts);
  std::vector<SeenStretch> found{{part.from, part.to, patch}};
  for (const double cut : cuts) {
    auto halves = split(found.back().patch, along, (cut - part.from) / (part.to - part.from));
    found.back() = {found.back().from, cut, std::move(halves.first)};
    found.push_back({cut, part.to, std::move(halves.second)});
  }
  return found;
}

/// How the patch goes on from the neighbour, into the filling's figures.
void see(Filling& filling, const HoleSide& side, Border border, const SeenStretch& stretch) {
  const auto [low, high] = std::minmax(stretch.from, stretch.to);
  const NurbsPatch neighbour = *side.neighbour_part(low, high);
  const bool is_reversed = stretch.from > stretch.to;
  if (side.continuity() == 1) {
    filling.angle = std::max(filling.angle, seam_angle(stretch.patch, border, neighbour, Border::v_end, is_reversed));
    return;
  }
  const SeamContinuity seam =
      seam_continuity(stretch.patch, border, neighbour, Border::v_end, kContinuityTolerance, {}, is_reversed);
  filling.angle = std::max(filling.angle, seam.angle);
  filling.curvature_difference = std::max(filling.curvature_difference, seam.curvature_difference);
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
    if (side.continuity() == 0) continue;
    for (const SeenStretch& stretch : stretches_of(side, part, patches[part.patch])) see(filling, side, part.border, stretch);
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
