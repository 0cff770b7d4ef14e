#include "splinecore/surface/fillet_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "creases.hpp"
#include "fillet_between.hpp"
#include "fitted_patch.hpp"
#include "meet/near_space.hpp"
#include "meet/said_outside.hpp"
#include "rim_start.hpp"
#include "rolling_ball.hpp"
#include "side_first.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/join.hpp"

namespace splinecore {

namespace {

/// v_start along the edge, u over [0, 1], v from 0.
NurbsPatch ready(const NurbsPatch& patch, Border side, bool is_reversed) {
  NurbsPatch made = with_side_first(patch, side);
  if (is_reversed) made = reversed(made, Axis::u);
  made = clamped(made, Axis::v);
  if (!made.knot_vector(Axis::u).periodic()) made = clamped(made, Axis::u);
  return with_domain(with_domain(made, Axis::u, {0.0, 1.0}), Axis::v, {0.0, 1.0});
}

/// @throws InvalidShape unless the sides are one edge
BesideEdge beside_edge(NurbsPatch first, NurbsPatch second, double tolerance, double unit) {
  const double gap = gap_between(first, second);
  if (gap <= tolerance) {
    const bool is_one_closed = first.knot_vector(Axis::u).periodic() != second.knot_vector(Axis::u).periodic();
    if (!is_one_closed || !is_closed(first) || !is_closed(second)) return {std::move(first), std::move(second), false, {}};
    return {closed_up(first), closed_up(second), false, {}};
  }
  if (auto found = beside_rim(first, second, tolerance)) return *std::move(found);
  throw InvalidShape("the sides are not one edge with the same parameters along it: they lie " + text_of(gap * unit) + " apart");
}

/// Where the contact with a patch is less smooth than the patch: at its own knots, for the ball goes by its tangent planes, and where
/// the ball is at a knot of the other one.
std::vector<double> joints_of(const NurbsPatch& patch, const NurbsPatch& other, const RollingBall& ball, bool is_first) {
  constexpr double kSame = 0x1p-30;
  const KnotVector& own = patch.knot_vector(Axis::u);
  const KnotVector& others = other.knot_vector(Axis::u);
  std::vector<double> found = softened(own);
  for (const double knot : inner_knots(others)) {
    const Contact contact = ball.at(knot, !is_first);
    const double reached = is_first ? contact.on_first.x : contact.on_second.x;
    const double at = own.periodic() ? reached - std::floor(reached) : reached;
    const bool is_own = std::ranges::any_of(own.knots(), [&](double u) { return std::abs(u - at) <= kSame; });
    if (is_own || !(at > kSame && at < 1.0 - kSame)) continue;
    const int smooth = others.degree() - multiplicity(others, knot) - 1;
    const int copies = std::clamp(own.degree() - smooth, 1, own.degree());
    found.insert(found.end(), static_cast<std::size_t>(copies), at);
  }
  std::ranges::sort(found);
  return found;
}

/// Of the tolerance, for what is left of the patches: the fillet is measured from where they should be.
constexpr double kCut = 0.25;

/// What is left of a patch beyond the contact, at each u of its own. Cut where the contact is a line of parameters.
Approximation<NurbsPatch> shortened(const NurbsPatch& patch, const NurbsPatch& other, const RollingBall& ball,
                                    const std::vector<double>& places, bool is_first, double tolerance) {
  constexpr double kLevel = 0x1p-44;
  constexpr std::size_t kMost = 1 << 14;
  const auto contact_at = [&](double u) {
    const Contact contact = ball.at(u, is_first);
    return is_first ? contact.on_first.y : contact.on_second.y;
  };
  const double first = contact_at(0.5);
  const bool is_level = std::ranges::all_of(places, [&](double u) { return std::abs(contact_at(u) - first) <= kLevel; });
  if (is_level) return {with_domain(split(patch, Axis::v, first).second, Axis::v, {0.0, 1.0}), 0.0};
  const int more = kSmooth - patch.knot_vector(Axis::u).degree();
  const NurbsPatch raised = more > 0 ? elevated(patch, Axis::u, more) : patch;
  const NurbsPatch model = refine(raised, Axis::u, joints_of(raised, other, ball, is_first));
  const auto surface = [&](std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> points) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double start = contact_at(u[i]);
      std::vector<double> at;
      for (const double t : v) at.push_back(start + t * (1.0 - start));
      evaluate_grid(patch, u.subspan(i, 1), at, std::span(&points[i * v.size()].x, 3 * v.size()));
    }
  };
  try {
    return fitted_patch(model, surface, kCut * tolerance, kMost);
  } catch (const SurfaceMissed& missed) {
    const std::string whose = is_first ? "the first patch" : "the second patch";
    throw ToleranceNotReached("the rest of " + whose + " beside the fillet cannot be fitted near " + share_text(missed.u) +
                              " of its edge", tolerance, missed.error() / kCut);
  }
}

/// Whether the ball touches both patches at the same u everywhere.
bool is_even(const RollingBall& ball, const std::vector<double>& places) {
  constexpr double kSame = 0x1p-36;
  return std::ranges::all_of(places, [&](double u) { return std::abs(ball.at(u, true).on_second.x - u) <= kSame; });
}

std::vector<RailNumber> over_unit(std::span<const RailNumber> radii, const Interval& domain, double unit) {
  std::vector<RailNumber> found;
  for (const RailNumber& radius : radii) {
    if (!(radius.value > 0.0 && std::isfinite(radius.value))) {
      throw InvalidShape("a radius of " + text_of(radius.value) + ": above 0 is expected");
    }
    if (!(radius.at >= domain.start && radius.at <= domain.end)) {
      throw InvalidShape("the radius at " + text_of(radius.at) + " is off the edge, which runs from " + text_of(domain.start) + " to " +
                         text_of(domain.end));
    }
    found.push_back({(radius.at - domain.start) / domain.length(), radius.value / unit});
  }
  return found;
}

}  // namespace

RoundedEdge fillet(const NurbsPatch& first, Border first_side, const NurbsPatch& second, Border second_side,
                   std::span<const RailNumber> radii, std::optional<double> tolerance) {
  if (tolerance) require_positive(*tolerance);
  for (const auto& [patch, side] : {std::pair(&first, first_side), std::pair(&second, second_side)}) {
    if (patch->knot_vector(axis_of(side)).periodic()) throw InvalidShape("the side is the seam of a periodic direction: it is not an edge");
  }
  const NearSpace space(together(first.points(), second.points()));
  const double unit = space.length(1.0);
  const double within = tolerance ? *tolerance / unit : 0x1p-20;
  const bool runs_against = run_against(first, first_side, second, second_side);
  const BesideEdge beside = beside_edge(ready(first.with_points(space.enter(first.points())), first_side, false),
                                        ready(second.with_points(space.enter(second.points())), second_side, runs_against), within, unit);
  const NurbsPatch& a = beside.first;
  const NurbsPatch& b = beside.second;
  const bool is_reversed = runs_against != beside.is_reversed;
  require_smooth(a, Axis::u);
  require_smooth(b, Axis::u);
  const bool is_closed = a.knot_vector(Axis::u).periodic() && b.knot_vector(Axis::u).periodic();
  const Interval along = first.knot_vector(axis_of(first_side) == Axis::u ? Axis::v : Axis::u).domain();
  const std::vector<RailNumber> over_edge = over_unit(radii, along, unit);
  const NumbersAlong by_edge(over_edge, {0.0, 1.0}, is_closed, "radius");
  const RollingBall ball(a, b, by_edge, beside.places);
  const std::vector<double> places = places_along(a, b);
  const auto within_tolerance = [&](const auto& make) { return said_outside(space, make); };
  const auto left_a = within_tolerance([&] { return shortened(a, b, ball, places, true, within); });
  const auto left_b = within_tolerance([&] { return shortened(b, a, ball, places, false, within); });
  const FilletBetween made = within_tolerance([&] {
    return !beside.places && is_even(ball, places) ? fillet_of_arcs(left_a.value, left_b.value, ball, within)
                                                   : slanted_fillet(left_a.value, left_b.value, ball, within);
  });
  const auto out = [&](const NurbsPatch& patch) { return patch.with_points(space.leave(patch.points())); };
  const NurbsPatch back_b = is_reversed ? reversed(made.second, Axis::u) : made.second;
  return {with_side_back(out(made.first), first_side), out(made.fillet), with_side_back(out(back_b), second_side),
          unit * std::max({made.error, left_a.error, left_b.error})};
}

}  // namespace splinecore
