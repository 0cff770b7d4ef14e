#include "splinecore/surface/fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/sort_by.hpp"
#include "basis/selection.hpp"
#include "border_loop.hpp"
#include "build/fit_options.hpp"
#include "expected_points.hpp"
#include "greville.hpp"
#include "hole.hpp"
#include "hole_borders.hpp"
#include "meet/near_space.hpp"
#include "round_filling.hpp"
#include "rows_beside.hpp"
#include "seen_filling.hpp"
#include "splinecore/base/errors.hpp"
#include "star.hpp"
#include "star_claims.hpp"

namespace splinecore {

namespace {

const NurbsPatch* patch_of(const FillSide& side) {
  const auto* neighbour = std::get_if<LoftNeighbour>(&side);
  return neighbour ? &neighbour->patch : nullptr;
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
    const auto* neighbour = std::get_if<LoftNeighbour>(&side);
    if (neighbour && (neighbour->continuity < 0 || neighbour->continuity > 2)) {
      throw InvalidShape("continuity " + std::to_string(neighbour->continuity) + " of a filling: 0 to 2 is expected");
    }
    if (neighbour && neighbour->patch.knot_vector(axis_of(neighbour->side)).periodic()) {
      throw InvalidShape("the side of a neighbour is the seam of a periodic direction: it is no edge");
    }
  }
  if (options.tolerance) require_tolerance(*options.tolerance);
  if (!(options.angle > 0.0)) throw InvalidShape("the angle " + text_of(options.angle) + " is not above 0");
}

FillSide entered(const FillSide& side, const NearSpace& space) {
  if (const auto* curve = std::get_if<NurbsCurve>(&side)) return curve->with_points(space.enter(curve->points()));
  LoftNeighbour neighbour = std::get<LoftNeighbour>(side);
  neighbour.patch = neighbour.patch.with_points(space.enter(neighbour.patch.points()));
  return neighbour;
}

NurbsCurve curve_of(const FillSide& side) {
  if (const auto* curve = std::get_if<NurbsCurve>(&side)) return *curve;
  const auto& neighbour = std::get<LoftNeighbour>(side);
  return boundary(neighbour.patch, neighbour.side);
}

std::vector<PartOfSide> parts_of(const Hole& hole) {
  if (hole.share == 1.0) {
    return {{0, 0.0, 1.0, 0, Border::v_start}, {1, 0.0, 1.0, 0, Border::u_end}, {2, 1.0, 0.0, 0, Border::v_end}, {3, 1.0, 0.0, 0, Border::u_start}};
  }
  std::vector<PartOfSide> parts;
  for (std::size_t k = 0; k < hole.sides.size(); ++k) {
    parts.push_back({k, 0.0, hole.share, k, Border::v_start});
    parts.push_back({hole.before(k), 1.0, hole.share, k, Border::u_start});
  }
  return parts;
}

/// Rows of control points of a patch along its part of a side, one more than the side's continuity.
std::vector<std::vector<glm::dvec3>> rows_along(const HoleSide& side, const PartOfSide& part, const KnotVector& knots) {
  std::vector<double> s;
  for (const double place : interpolation_places(knots)) s.push_back(part.from + (part.to - part.from) * place);
  std::vector<std::vector<glm::dvec3>> across{side.points(s)};
  for (int order = 1; order <= side.continuity(); ++order) across.push_back(side.across(s, order));
  return rows_beside(knots, is_at_end(part.border) ? reversed(knots).knots : knots, across);
}

std::vector<NurbsPatch> patches_of(const Star& star, const std::vector<glm::dvec3>& points) {
  std::vector<NurbsPatch> patches;
  for (std::size_t k = 0; k < star.count; ++k) {
    std::vector<glm::dvec4> net;
    for (std::size_t i = 0; i < star.width(); ++i) {
      for (std::size_t j = 0; j < star.width(); ++j) net.emplace_back(points[star.at(k, i, j)], 1.0);
    }
    patches.push_back(NurbsPatch::make(star.knots, star.knots, std::move(net)));
  }
  return patches;
}

std::vector<glm::dvec3> points_or_zero(const std::vector<std::optional<glm::dvec3>>& given) {
  std::vector<glm::dvec3> points;
  for (const auto& point : given) points.push_back(point.value_or(glm::dvec3(0.0)));
  return points;
}

/// Patches that fill a hole, and what of their control points its sides decide.
struct ClaimedStar {
  Star star;
  std::vector<std::optional<glm::dvec3>> points;

  /// With the others at the origin.
  std::vector<NurbsPatch> patches() const { return patches_of(star, points_or_zero(points)); }
};

ClaimedStar claimed_star(const Hole& hole, const std::vector<PartOfSide>& parts, const KnotVector& knots) {
  const bool is_one = hole.share == 1.0;
  const Star star{knots, is_one ? 1 : hole.sides.size(), is_one, hole.continuity() + 1};
  const std::size_t last = star.width() - 1;
  StarClaims claims(star);
  for (const PartOfSide& part : parts) {
    const auto rows = rows_along(hole.sides[part.side], part, knots);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t across = is_at_end(part.border) ? last - r : r;
      for (std::size_t j = 0; j <= last; ++j) {
        const bool is_along_u = axis_of(part.border) == Axis::v;
        claims.add(part.patch, is_along_u ? j : across, is_along_u ? across : j, rows[r][j], static_cast<int>(r));
      }
    }
  }
  return {star, claims.points()};
}

std::vector<NurbsPatch> solved(const Hole& hole, const ClaimedStar& claimed) {
  const Star& star = claimed.star;
  const bool is_one = star.count == 1;
  std::vector<NurbsPatch> patches = is_one ? claimed.patches() : patches_of(star, solved_star(star, claimed.points));
  const std::vector<glm::dvec3> expected = expected_points(hole, star, patches);
  return expected.empty() && !is_one ? patches : patches_of(star, solved_star(star, claimed.points, expected));
}

/// A place of the parameters of patches at which a side is less smooth, and how often its knot is needed for that.
struct SideKnot {
  double at;
  int copies;
};

/// The inner knots of all sides, as patches of a degree have them along their parts of these.
std::vector<SideKnot> side_knots(const Hole& hole, const std::vector<PartOfSide>& parts, int degree) {
  constexpr double kSame = 1e-7;
  std::vector<SideKnot> all;
  for (const PartOfSide& part : parts) {
    const KnotVector& knots = hole.sides[part.side].knots();
    for (const double knot : knots.knots()) {
      const double at = (knot - part.from) / (part.to - part.from);
      const int smooth = std::max(1, knots.degree() - multiplicity(knots, knot));
      if (at > kSame && at < 1.0 - kSame && smooth < degree) all.push_back({at, degree - smooth});
    }
  }
  sort_by(all, [](const SideKnot& knot) { return knot.at; });
  std::vector<SideKnot> found;
  for (const SideKnot& one : all) {
    if (!found.empty() && one.at - found.back().at <= kSame) {
      found.back().copies = std::max(found.back().copies, one.copies);
    } else {
      found.push_back(one);
    }
  }
  return found;
}

/// Each stretch between inner knots of sides in so many spans.
KnotVector knots_with(int degree, int spans, std::vector<SideKnot> inner) {
  inner.push_back({1.0, degree + 1});
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (const SideKnot& one : inner) {
    const double start = knots.back();
    for (int k = 1; k < spans; ++k) knots.push_back(start + (one.at - start) * k / spans);
    knots.insert(knots.end(), static_cast<std::size_t>(one.copies), one.at);
  }
  return KnotVector::make(degree, std::move(knots));
}

/// The lowest degree of patches with the sides of a hole, weights and all; at least 3.
int least_degree(const Hole& hole) {
  int least = 3;
  for (const HoleSide& side : hole.sides) least = std::max(least, side.least_degree());
  return least;
}

/// One patch that has its sides exactly, of as low a degree as its neighbours allow.
std::optional<Filling> exactly_bordered(const Hole& hole, const std::vector<PartOfSide>& parts, const FillLimits& limits) {
  constexpr int kMostDegree = 7;
  const auto goes_on = [](const HoleSide& side) { return side.continuity() == 1; };
  if (hole.share != 1.0 || hole.continuity() > 1 || std::ranges::none_of(hole.sides, goes_on)) return {};
  const BorderPairs borders = hole_borders(hole);
  for (int degree = least_degree(hole); degree <= kMostDegree; ++degree) {
    const BicubicSum sum = bicubic_sum(borders.along_u, borders.along_v, degree);
    if (!keeps_weights_positive(sum)) return {};
    Filling filling = seen_along_sides(hole, parts, {sum.patch}, limits);
    if (!limits.are_met(filling)) continue;
    filling.patches = {sum.patch};
    return filling;
  }
  return {};
}

/// Patches from the sides of a round hole to one point.
Filling filled_round(Hole& hole, double tolerance, double angle) {
  constexpr int kMostDegree = 9;
  constexpr int kForCurvatures = 7;
  const Apex apex = apex_of(hole);
  agree_round(hole, apex);
  std::vector<PartOfSide> parts;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) parts.push_back({i, 0.0, 1.0, i, Border::v_start});
  const FillLimits limits{tolerance, angle};
  for (int degree = std::max(least_degree(hole), hole.continuity() == 2 ? kForCurvatures : 0);; ++degree) {
    const bool is_last = degree >= kMostDegree;
    std::vector<NurbsPatch> patches = round_filling(hole, apex, degree);
    Filling filling = seen_along_sides(hole, parts, patches, is_last ? std::nullopt : std::optional(limits));
    if (!is_last && !limits.are_met(filling)) continue;
    filling.inner_angle = angle_between_patches(patches, Border::u_start);
    filling.patches = std::move(patches);
    if (limits.are_met(filling) || (is_last && filling.gap <= tolerance)) return filling;
    if (!is_last) continue;
    throw ToleranceNotReached("the filling cannot reach its sides", tolerance, filling.gap);
  }
}

Filling filled(Hole& hole, double tolerance, double angle) {
  agree_at_corners(hole);
  constexpr int kMostSpans = 8;
  const int degree = hole.continuity() == 2 ? 7 : 5;
  const std::vector<PartOfSide> parts = parts_of(hole);
  const FillLimits limits{tolerance, angle};
  if (const auto filling = exactly_bordered(hole, parts, limits)) return *filling;
  std::vector<SideKnot> inner = side_knots(hole, parts, degree);
  constexpr std::size_t kMostSideKnots = 5;
  if (inner.size() > kMostSideKnots) inner.clear();
  for (int spans = 1;; spans *= 2) {
    const bool is_last = spans * (static_cast<int>(inner.size()) + 1) >= kMostSpans;
    const ClaimedStar claimed = claimed_star(hole, parts, knots_with(degree, spans, inner));
    Filling filling = seen_along_sides(hole, parts, claimed.patches(), is_last ? std::nullopt : std::optional(limits));
    if (!is_last && !limits.are_met(filling)) continue;
    filling.patches = solved(hole, claimed);
    filling.inner_angle = angle_between_patches(filling.patches, Border::v_end);
    if (limits.are_met(filling) || (is_last && filling.gap <= tolerance)) return filling;
    if (!is_last) continue;
    throw ToleranceNotReached("the filling cannot reach its sides with " + std::to_string(spans) + " spans", tolerance, filling.gap);
  }
}

}  // namespace

Filling fill(std::span<const FillSide> sides, const FillOptions& options) {
  require_sides(sides, options);
  const NearSpace space(points_of(sides));
  const double unit = space.length(1.0);
  std::vector<FillSide> near;
  std::vector<NurbsCurve> curves;
  for (const FillSide& side : sides) {
    near.push_back(entered(side, space));
    curves.push_back(curve_of(near.back()));
  }
  const double tolerance = options.tolerance ? *options.tolerance / unit : 0x1p-20;
  const BorderLoop loop = border_loop(curves, tolerance);
  Hole hole{{}, sides.size() == 4 ? 1.0 : 0.5};
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto* neighbour = std::get_if<LoftNeighbour>(&near[i]);
    hole.sides.emplace_back(loop.curves[i], neighbour ? std::optional(*neighbour) : std::nullopt);
  }
  const bool is_free = std::ranges::all_of(hole.sides, [](const HoleSide& side) { return side.continuity() == 0; });
  Filling filling = !is_free && is_round(hole) ? filled_round(hole, tolerance, options.angle) : filled(hole, tolerance, options.angle);
  for (NurbsPatch& patch : filling.patches) patch = patch.with_points(space.leave(patch.points()));
  filling.gap = space.length(std::max(filling.gap, loop.error));
  filling.curvature_difference /= unit;
  return filling;
}

}  // namespace splinecore
