#include "splinecore/surface/fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "base/positive_weights.hpp"
#include "base/require.hpp"
#include "border_loop.hpp"
#include "build/fit_options.hpp"
#include "fairness.hpp"
#include "guided_points.hpp"
#include "hole.hpp"
#include "hole_borders.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "patch_folds.hpp"
#include "round_filling.hpp"
#include "seen_filling.hpp"
#include "star_filling.hpp"
#include "star_knots.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/surface/coons.hpp"

namespace splinecore {

namespace {

const NurbsPatch* patch_of(const FillSide& side) {
  const auto* neighbor = std::get_if<LoftNeighbor>(&side);
  return neighbor ? &neighbor->patch : nullptr;
}

std::vector<glm::dvec4> points_of(std::span<const FillSide> sides) {
  std::vector<glm::dvec4> all;
  for (const FillSide& side : sides) {
    const auto* curve = std::get_if<NurbsCurve>(&side);
    const auto points = curve ? curve->points() : patch_of(side)->points();
    all.insert(all.end(), points.begin(), points.end());
  }
  return all;
}

void require_sides(std::span<const FillSide> sides, const FillOptions& options) {
  constexpr std::size_t kLeast = 3;
  constexpr std::size_t kMost = 8;
  if (sides.size() < kLeast || sides.size() > kMost) {
    throw InvalidShape("a hole of " + std::to_string(sides.size()) + " sides: 3 to 8 are expected");
  }
  for (const FillSide& side : sides) {
    const auto* neighbor = std::get_if<LoftNeighbor>(&side);
    if (neighbor && (neighbor->continuity < 0 || neighbor->continuity > 2)) {
      throw InvalidShape("continuity " + std::to_string(neighbor->continuity) + " of a filling: 0 to 2 is expected");
    }
    if (neighbor && neighbor->patch.knot_vector(axis_of(neighbor->side)).periodic()) {
      throw InvalidShape("the side of a neighbor is the seam of a periodic direction: it is not an edge");
    }
  }
  if (options.tolerance) require_positive(*options.tolerance);
  if (!(options.angle > 0.0)) throw InvalidShape("the angle " + text_of(options.angle) + " is not above 0");
}

FillSide entered(const FillSide& side, const NearSpace& space) {
  if (const auto* curve = std::get_if<NurbsCurve>(&side)) return curve->with_points(space.enter(curve->points()));
  LoftNeighbor neighbor = std::get<LoftNeighbor>(side);
  neighbor.patch = neighbor.patch.with_points(space.enter(neighbor.patch.points()));
  return neighbor;
}

NurbsCurve curve_of(const FillSide& side) {
  if (const auto* curve = std::get_if<NurbsCurve>(&side)) return *curve;
  const auto& neighbor = std::get<LoftNeighbor>(side);
  return boundary(neighbor.patch, neighbor.side);
}

/// The lowest degree of patches with the sides of a hole, weights and all; at least 3.
int least_degree(const Hole& hole) {
  int least = 3;
  for (const HoleSide& side : hole.sides) least = std::max(least, side.least_degree());
  return least;
}

/// By more than rounding and what else is the same in both make of it: angles at corners that nobody can mend are in all fillings.
bool is_less(double angle, double other) {
  constexpr double kAbout = 0.98;
  return angle < kAbout * other;
}

/// One patch that has its sides exactly, of as low a degree as its neighbors allow; where that is none, of those the one with the
/// least angle to them. None without such a patch.
std::optional<Filling> exactly_bordered(const Hole& hole, const FillLimits& limits) {
  const auto goes_on = [](const HoleSide& side) { return side.continuity() == 1; };
  if (hole.share != 1.0 || hole.continuity() > 1 || std::ranges::none_of(hole.sides, goes_on)) return {};
  const BorderPairs borders = hole_borders(hole);
  constexpr int kMostDegree = 64;
  const int least = least_degree(hole);
  if (least > kMostDegree) return {};
  const int most = std::max(7, least);
  std::optional<Filling> best;
  for (int degree = least; degree <= most; ++degree) {
    const BicubicSum sum = bicubic_sum(borders.along_u, borders.along_v, degree);
    if (!have_positive_weights(sum.patch.points())) return best;
    Filling filling = seen_along_sides(hole, star_parts(hole), {sum.patch});
    if (filling.gap > limits.gap || (best && !is_less(filling.angle, best->angle))) continue;
    filling.patches = {sum.patch};
    best = std::move(filling);
    if (limits.are_met(*best)) return best;
  }
  return best;
}

std::vector<PartOfSide> round_parts(const Hole& hole) {
  std::vector<PartOfSide> parts;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) parts.push_back({i, 0.0, 1.0, i, Border::v_start});
  return parts;
}

/// Patches from the sides of a round hole to one point; with the highest degree where the limits are not met.
Filling round_filled(Hole hole, const FillLimits& limits, LeavingWay leaving) {
  constexpr int kMostDegree = 9;
  constexpr int kForCurvatures = 7;
  const Apex apex = apex_of(hole, leaving);
  agree_round(hole, apex);
  const std::vector<PartOfSide> parts = round_parts(hole);
  for (int degree = std::max(least_degree(hole), hole.continuity() == 2 ? kForCurvatures : 0);; ++degree) {
    const bool is_last = degree >= kMostDegree;
    std::vector<NurbsPatch> patches = round_filling(hole, apex, degree);
    Filling filling = seen_along_sides(hole, parts, patches, is_last ? std::nullopt : std::optional(limits));
    if (!is_last && !limits.are_met(filling)) continue;
    filling.inner_angle = angle_between_patches(patches, Border::u_start);
    filling.patches = std::move(patches);
    if (is_last || limits.are_met(filling)) return filling;
  }
}

/// Whether normals turn round in a patch, or from one to the next.
bool is_folded(const Filling& filling, const FillLimits& limits) {
  constexpr double kUpright = 0.5 * std::numbers::pi;
  return filling.inner_angle > kUpright ||
         std::ranges::any_of(filling.patches, [&](const NurbsPatch& patch) { return fold_of(patch, limits.gap).has_value(); });
}

/// In the second way where the first one folds.
Filling round_filled(const Hole& hole, const FillLimits& limits) {
  Filling filling = round_filled(hole, limits, LeavingWay::straight_on);
  return is_folded(filling, limits) ? round_filled(hole, limits, LeavingWay::nearest) : filling;
}

/// Patches round a point, or one; with the most spans where the limits are not met. Where sides are missed, with shorter ones
/// where these need them; a gap above the limit where that is in vain.
Filling star_filled(const Hole& hole, const HoleGuide* guide, const FillLimits& limits) {
  constexpr std::array kShares{0x1p-2, 0x1p-5, 0x1p-9};  // of the gap, for polynomials on spans
  const StarKnots knots(hole);
  std::size_t next = 0;
  for (int spans = 1;;) {
    const bool is_last = knots.are_all(spans);
    const auto graded = [&] { return knots.graded(hole, spans, kShares[next - 1] * limits.gap); };
    const ClaimedStar claimed = claimed_star(hole, next == 0 ? knots.with(spans) : graded());
    Filling filling = seen_along_sides(hole, star_parts(hole), claimed.patches(), is_last ? std::nullopt : std::optional(limits));
    if (!is_last && !limits.are_met(filling)) {
      spans *= 2;
      continue;
    }
    if (filling.gap > limits.gap && next < kShares.size()) {
      ++next;
      continue;
    }
    if (filling.gap > limits.gap) {
      filling.patches = claimed.patches();
      return filling;
    }
    filling.patches = solved(hole, claimed, guide);
    filling.inner_angle = angle_between_patches(filling.patches, Border::v_end);
    if (is_last || limits.are_met(filling)) return filling;
    spans *= 2;
  }
}

/// A filling to choose from.
struct FillCandidate {
  Filling filling;
  bool is_folded;
  SurfaceBending bending;
};

FillCandidate candidate_of(Filling filling, const FillLimits& limits) {
  const bool folds = is_folded(filling, limits);
  const SurfaceBending bending = folds ? SurfaceBending() : bending_of(filling.patches);
  return {std::move(filling), folds, bending};
}

/// Whether a plain filling bends about as evenly as what a guide leads.
bool is_fair(const SurfaceBending& plain, const SurfaceBending& guided) {
  constexpr double kSlight = 0.01;
  return plain.uneven <= guided.uneven + kSlight * plain.whole;
}

/// Of two stars the plain one, unless the other one is fairer.
Filling fairer(FillCandidate plain, FillCandidate guided, const FillLimits& limits) {
  const bool is_reached = guided.filling.gap <= limits.gap;
  const bool is_near = limits.are_met(guided.filling) || !limits.are_met(plain.filling);
  const bool is_fairer = plain.is_folded || !is_fair(plain.bending, guided.bending);
  return is_reached && !guided.is_folded && is_near && is_fairer ? std::move(guided.filling) : std::move(plain.filling);
}

/// Patches round a point, that go by a guide where that bends less.
Filling fairest_star(const Hole& plain_hole, Hole guided_hole, const FillLimits& limits) {
  FillCandidate plain = candidate_of(star_filled(plain_hole, nullptr, limits), limits);
  const bool is_reached = plain.filling.gap <= limits.gap;
  const std::optional<HoleGuide> guide = is_reached ? HoleGuide::of(guided_hole) : std::nullopt;
  if (!guide) return std::move(plain.filling);
  const std::optional<SurfaceBending> least = guided_bending(guided_hole, *guide);
  if (!plain.is_folded && (!least || is_fair(plain.bending, *least))) return std::move(plain.filling);
  agree_at_corners(guided_hole, &*guide);
  return fairer(std::move(plain), candidate_of(star_filled(guided_hole, &*guide, limits), limits), limits);
}

bool goes_on_somewhere(const Hole& hole) {
  return std::ranges::any_of(hole.sides, [](const HoleSide& side) { return side.continuity() > 0; });
}

/// A Coons patch of four curves, with their weights: of straight lines between them, or of cubics, which keeps their pace. None
/// where each has a weight that is not above 0, or folds.
std::optional<Filling> coons_filled(const Hole& hole, const FillLimits& limits) {
  const auto of_lines = [&] {
    std::vector<NurbsCurve> curves;
    for (const HoleSide& side : hole.sides) curves.push_back(side.curve());
    return coons(curves, limits.gap).value;
  };
  const auto of_cubics = [&] {
    const BorderPairs borders = hole_borders(hole);
    return bicubic_sum(borders.along_u, borders.along_v).patch;
  };
  const auto filled_with = [&](const auto& make) -> std::optional<Filling> {
    try {
      const NurbsPatch patch = make();
      if (!have_positive_weights(patch.points())) return {};
      Filling filling = seen_along_sides(hole, star_parts(hole), {patch});
      filling.patches = {patch};
      return filling.gap > limits.gap || is_folded(filling, limits) ? std::nullopt : std::optional(std::move(filling));
    } catch (const InvalidShape&) {
      return {};  // weights of both signs at the ends of a curve: the star's own fault is said
    }
  };
  std::optional<Filling> filling = filled_with(of_lines);
  return filling ? filling : filled_with(of_cubics);
}

Filling filled(Hole& hole, const FillLimits& limits) {
  const bool goes_on = goes_on_somewhere(hole);
  if (goes_on && is_round(hole)) return round_filled(hole, limits);
  const Hole given = hole;
  agree_at_corners(hole, nullptr);
  std::optional<Filling> exact = exactly_bordered(hole, limits);
  const bool is_sound = exact && !is_folded(*exact, limits);
  if (is_sound && limits.are_met(*exact)) return *exact;
  const bool has_guide = goes_on && hole.share < 1.0;
  Filling star = has_guide ? fairest_star(hole, given, limits) : star_filled(hole, nullptr, limits);
  if (!goes_on && hole.share == 1.0 && (star.gap > limits.gap || is_folded(star, limits))) {
    std::optional<Filling> of_curves = coons_filled(hole, limits);
    if (of_curves) return *std::move(of_curves);
  }
  const bool is_better = star.gap <= limits.gap && (limits.are_met(star) || !is_sound || is_less(star.angle, exact->angle));
  return exact && !is_better ? *exact : star;
}

/// The name of the side from which the filling is farthest off.
/// @param measure  how far, of what is seen along one side
template <class Measure>
std::string worst_side(const Hole& hole, const Filling& filling, const Measure& measure) {
  const bool is_dome = goes_on_somewhere(hole) && is_round(hole);
  const std::vector<PartOfSide> parts = is_dome ? round_parts(hole) : star_parts(hole);
  std::string worst;
  double largest = -1.0;
  for (const PartOfSide& part : parts) {
    const double off = measure(seen_along_sides(hole, {part}, filling.patches));
    if (!(off > largest)) continue;
    largest = off;
    const SideNumbers numbers = hole.sides[part.side].numbers();
    worst = "sides" + index_text(numbers.first) + (numbers.last == numbers.first ? "" : " to sides" + index_text(numbers.last));
  }
  return worst;
}

void require_reached(const Hole& hole, const Filling& filling, const FillLimits& limits) {
  if (filling.gap <= limits.gap) return;
  const std::string name = worst_side(hole, filling, [](const Filling& seen) { return seen.gap; });
  throw ToleranceNotReached("the filling cannot reach its sides: " + name + " is missed", limits.gap, filling.gap);
}

void require_unfolded(const Hole& hole, const Filling& filling, const FillLimits& limits, const NearSpace& space) {
  constexpr double kUpright = 0.5 * std::numbers::pi;
  if (filling.angle > kUpright) {
    const std::string name = worst_side(hole, filling, [](const Filling& seen) { return seen.angle; });
    throw InvalidShape("the filling would turn back over the neighbor of " + name + ": every surface there would fold");
  }
  const std::string why = ": its sides, or the continuations of their neighbors, leave no surface without a fold";
  for (const NurbsPatch& patch : filling.patches) {
    const std::optional<glm::dvec3> fold = fold_of(patch, limits.gap);
    if (!fold) continue;
    const glm::dvec3 at = space.leave(*fold);
    throw InvalidShape("the filling turns back over itself at (" + text_of(at.x) + ", " + text_of(at.y) + ", " + text_of(at.z) + ")" + why);
  }
  if (filling.inner_angle > kUpright) throw InvalidShape("the filling turns back over itself where its patches meet" + why);
}

/// Of the borders, not of what lies beyond.
double size_of(std::span<const FillSide> sides) {
  std::vector<glm::dvec4> all;
  for (const FillSide& side : sides) {
    const NurbsCurve curve = curve_of(side);
    all.insert(all.end(), curve.points().begin(), curve.points().end());
  }
  return NearSpace(all).length(1.0);
}

Filling fill_near(std::span<const FillSide> sides, const FillLimits& limits, const NearSpace& space) {
  std::vector<NurbsCurve> curves;
  for (const FillSide& side : sides) curves.push_back(curve_of(side));
  const BorderLoop loop = border_loop(curves, limits.gap);
  std::vector<SidePiece> pieces;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto* neighbor = std::get_if<LoftNeighbor>(&sides[i]);
    const bool goes_on = neighbor && neighbor->continuity > 0;
    pieces.emplace_back(loop.curves[i], goes_on ? std::optional(*neighbor) : std::nullopt, i);
  }
  Hole hole = hole_of(pieces);
  Filling filling = filled(hole, limits);
  require_reached(hole, filling, limits);
  require_unfolded(hole, filling, limits, space);
  filling.gap += loop.error;
  return filling;
}

}  // namespace

Filling fill(std::span<const FillSide> sides, const FillOptions& options) {
  require_sides(sides, options);
  const NearSpace space(points_of(sides));
  const double unit = space.length(1.0);
  std::vector<FillSide> near;
  for (const FillSide& side : sides) near.push_back(entered(side, space));
  const FillLimits limits{options.tolerance ? *options.tolerance / unit : 0x1p-20 * size_of(near), options.angle};
  Filling filling = said_outside(space, [&] { return fill_near(near, limits, space); });
  for (NurbsPatch& patch : filling.patches) patch = patch.with_points(space.leave(patch.points()));
  filling.gap = space.length(filling.gap);
  filling.curvature_difference /= unit;
  return filling;
}

}  // namespace splinecore
