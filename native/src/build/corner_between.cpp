#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "curve_ends.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/corners.hpp"
#include "splinecore/build/extend.hpp"
#include "splinecore/build/fillet.hpp"
#include "splinecore/build/part.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/meet/intersections.hpp"

namespace splinecore {

namespace {

/// Both open ends go on straight; the parameters of the curve remain.
NurbsCurve longer_at_ends(const NurbsCurve& curve, double by) {
  if (is_closed(curve)) return curve;
  return extended(extended(curve, false, by, Extension::straight), true, by, Extension::straight);
}

/// How far a place of both curves is from what is kept, as parts of their domains.
double away_from(const NurbsCurve& a, const NurbsCurve& b, const std::array<double, 2>& at,
                 const std::array<double, 2>& kept) {
  return std::abs(at[0] - kept[0]) / a.domain().length() + std::abs(at[1] - kept[1]) / b.domain().length();
}

/// Whether nothing is left of a curve up to a cut, or behind it; never of a closed one, which is not cut.
bool is_taken_whole(const NurbsCurve& curve, double cut, bool is_left_before) {
  const Interval domain = curve.domain();
  return !is_closed(curve) && (is_left_before ? cut - domain.start : domain.end - cut) <= kNothing * domain.length();
}

/// The fillet that leaves what is kept, the nearest one; or else one that takes a curve whole.
std::optional<Fillet> fillet_beside(const NurbsCurve& a, const NurbsCurve& b, double radius,
                                    const std::array<double, 2>& kept, const glm::dvec3& normal) {
  std::optional<Fillet> found;
  bool takes_one = false;
  double least = 0.0;
  for (const Fillet& fillet : fillets(a, b, radius, normal)) {
    const bool takes_a = is_taken_whole(a, fillet.a, fillet.goes_on_a);
    const bool takes_b = is_taken_whole(b, fillet.b, !fillet.goes_on_b);
    const bool leaves_a = takes_a || is_closed(a) || fillet.goes_on_a == (kept[0] < fillet.a);
    const bool leaves_b = takes_b || is_closed(b) || fillet.goes_on_b == (kept[1] > fillet.b);
    if (!leaves_a || !leaves_b) continue;
    const double away = away_from(a, b, {fillet.a, fillet.b}, kept);
    const bool takes = takes_a || takes_b;
    if (found && (takes != takes_one ? takes : away >= least)) continue;
    found = fillet;
    takes_one = takes;
    least = away;
  }
  return found;
}

/// The part of a curve before or behind a cut, from its own end, which may be where it was made longer; none if that is nothing.
std::optional<NurbsCurve> kept_part(const NurbsCurve& curve, const NurbsCurve& longer, double cut, bool is_before) {
  const Interval domain = curve.domain();
  if (is_closed(curve)) return curve;
  if (is_taken_whole(curve, cut, is_before)) return {};
  return is_before ? part(longer, domain.start, cut) : part(longer, cut, domain.end);
}

std::optional<CurveIntersection> corner_beside(const NurbsCurve& a, const NurbsCurve& b,
                                               const std::array<double, 2>& kept) {
  const CurveIntersections both = intersections(a, b);
  if (!both.overlaps.empty()) throw InvalidShape("the curves coincide along a segment: they make no corner");
  std::optional<CurveIntersection> found;
  for (const CurveIntersection& place : both.places) {
    if (found && away_from(a, b, {place.a, place.b}, kept) >= away_from(a, b, {found->a, found->b}, kept)) continue;
    found = place;
  }
  return found;
}

/// The parameter at a length from a corner towards what is kept.
double parameter_towards(const NurbsCurve& curve, double corner, double length, double kept) {
  const double at = lengths_at_parameters(curve, std::span(&corner, 1)).front();
  const auto found = parameter_along(curve, kept < corner ? at - length : at + length);
  if (!found) throw InvalidShape("a curve is too short for a chamfer of " + text_of(length));
  return *found;
}

double size_of_both(const NurbsCurve& a, const NurbsCurve& b) {
  return 2.0 * NearSpace(together(a.points(), b.points())).length(1.0);
}

void require_inside(const NurbsCurve& curve, double u) {
  if (u >= curve.domain().start && u <= curve.domain().end) return;
  throw InvalidShape("kept = " + text_of(u) + " is outside of the curve's domain");
}

}  // namespace

CornerBetween filleted(const NurbsCurve& a, const NurbsCurve& b, double radius, const std::array<double, 2>& kept,
                       const glm::dvec3& normal) {
  require_inside(a, kept[0]);
  require_inside(b, kept[1]);
  const auto made = [&](const NurbsCurve& of_a, const NurbsCurve& of_b) -> std::optional<CornerBetween> {
    const std::optional<Fillet> fillet = fillet_beside(of_a, of_b, radius, kept, normal);
    if (!fillet) return {};
    return CornerBetween{kept_part(a, of_a, fillet->a, fillet->goes_on_a), fillet->arc,
                         kept_part(b, of_b, fillet->b, !fillet->goes_on_b)};
  };
  if (const auto found = made(a, b)) return *found;
  const double by = size_of_both(a, b) + radius;
  if (const auto found = made(longer_at_ends(a, by), longer_at_ends(b, by))) return *found;
  throw InvalidShape("no arc of radius " + text_of(radius) + " touches both curves there");
}

CornerBetween chamfered(const NurbsCurve& a, const NurbsCurve& b, const std::array<double, 2>& lengths,
                        const std::array<double, 2>& kept) {
  require_inside(a, kept[0]);
  require_inside(b, kept[1]);
  for (const double length : lengths) {
    if (!(length >= 0.0) || !std::isfinite(length)) throw InvalidShape("a length is not 0 or more");
  }
  if (lengths[0] == 0.0 && lengths[1] == 0.0) throw InvalidShape("both lengths are 0: there is nothing to chamfer");
  const auto made = [&](const NurbsCurve& of_a, const NurbsCurve& of_b) -> std::optional<CornerBetween> {
    const std::optional<CurveIntersection> corner = corner_beside(of_a, of_b, kept);
    if (!corner) return {};
    const double on_a = parameter_towards(of_a, corner->a, lengths[0], kept[0]);
    const double on_b = parameter_towards(of_b, corner->b, lengths[1], kept[1]);
    return CornerBetween{kept_part(a, of_a, on_a, kept[0] < corner->a), line_between(point_at(of_a, on_a), point_at(of_b, on_b)),
                         kept_part(b, of_b, on_b, kept[1] < corner->b)};
  };
  if (const auto found = made(a, b)) return *found;
  const double by = size_of_both(a, b);
  if (const auto found = made(longer_at_ends(a, by), longer_at_ends(b, by))) return *found;
  throw InvalidShape("the curves do not meet, nor do their tangents");
}

}  // namespace splinecore
