#include "seen_filling.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/length.hpp"
#include "measure/seam_angle.hpp"
#include "span_places.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/seam.hpp"

namespace splinecore {

namespace {

/// Places over [0, 1] that lie closer towards the ends of every span of a border and of its side.
std::vector<double> gap_places(const NurbsCurve& border, const HoleSide& side, const PartOfSide& part) {
  constexpr int kInSpan = 24;
  std::vector<double> ends(border.knot_vector().knots().begin(), border.knot_vector().knots().end());
  for (const double knot : side.knots().knots()) {
    const double at = (knot - part.from) / (part.to - part.from);
    if (at > 0.0 && at < 1.0) ends.push_back(at);
  }
  return places_of_spans(std::move(ends), kInSpan);
}

/// How far a border is from its side at places of it.
std::vector<double> gaps_at(const std::vector<double>& at, const NurbsCurve& border, const HoleSide& side, const PartOfSide& part) {
  std::vector<double> s;
  for (const double place : at) s.push_back(part.from + (part.to - part.from) * place);
  std::vector<glm::dvec3> points(at.size());
  evaluate(border, at, std::span(&points.front().x, 3 * points.size()));
  const std::vector<glm::dvec3> wanted = side.points(s);
  std::vector<double> found;
  for (std::size_t k = 0; k < at.size(); ++k) found.push_back(distance_of(points[k], wanted[k]));
  return found;
}

/// The largest, looked for closer about where it is if it is more than rounding.
double gap_along(const HoleSide& side, const PartOfSide& part, const NurbsPatch& patch) {
  constexpr double kRounding = 1e-13;
  constexpr int kParts = 40;
  const NurbsCurve border = boundary(patch, part.border);
  const std::vector<double> places = gap_places(border, side, part);
  const std::vector<double> gaps = gaps_at(places, border, side, part);
  const auto at = static_cast<std::size_t>(std::ranges::max_element(gaps) - gaps.begin());
  if (gaps[at] <= kRounding) return gaps[at];
  const double from = places[at > 0 ? at - 1 : 0];
  const double to = places[std::min(at + 1, places.size() - 1)];
  std::vector<double> closer;
  for (int k = 1; k < kParts; ++k) closer.push_back(from + (to - from) * k / kParts);
  return std::max(gaps[at], std::ranges::max(gaps_at(closer, border, side, part)));
}

/// The stretch of a part that has one neighbor, and the patch along it.
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
    if (joint > low + kSamePlace && joint < high - kSamePlace) cuts.push_back(joint);
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

/// How the patch goes on from the neighbor, into the filling's figures.
void see(Filling& filling, const HoleSide& side, Border border, const SeenStretch& stretch) {
  const auto [low, high] = std::minmax(stretch.from, stretch.to);
  const NurbsPatch neighbor = *side.neighbor_part(low, high);
  const bool is_reversed = stretch.from > stretch.to;
  if (side.continuity_between(low, high) == 1) {
    filling.angle = std::max(filling.angle, seam_angle(stretch.patch, border, neighbor, Border::v_end, is_reversed));
    return;
  }
  const SeamContinuity seam =
      seam_continuity(stretch.patch, border, neighbor, Border::v_end, kContinuityTolerance, {}, is_reversed);
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
