#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/length.hpp"
#include "curve_ends.hpp"
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

/// A parameter of each curve, about which they are kept, and how long their own domains are.
struct KeptPlaces {
  std::array<double, 2> at;
  std::array<double, 2> lengths;

  /// How far a place of both curves is from there, as parts of their domains.
  double away(double a, double b) const { return std::abs(a - at[0]) / lengths[0] + std::abs(b - at[1]) / lengths[1]; }
};

/// Whether nothing is left of a curve up to a cut, or behind it; never of a closed one, which is not cut.
bool is_taken_whole(const NurbsCurve& curve, double cut, bool is_left_before) {
  const Interval domain = curve.domain();
  return !is_closed(curve) && (is_left_before ? cut - domain.start : domain.end - cut) <= kNothing * domain.length();
}

/// The fillet that leaves what is kept, the nearest one; or else one that takes a curve whole.
std::optional<Fillet> fillet_beside(const NurbsCurve& a, const NurbsCurve& b, double radius,
                                    const KeptPlaces& kept, const glm::dvec3& normal) {
  std::optional<Fillet> found;
  bool takes_one = false;
  double least = 0.0;
  for (const Fillet& fillet : fillets(a, b, radius, normal)) {
    const bool takes_a = is_taken_whole(a, fillet.a, fillet.goes_on_a);
    const bool takes_b = is_taken_whole(b, fillet.b, !fillet.goes_on_b);
    const bool leaves_a = takes_a || is_closed(a) || fillet.goes_on_a == (kept.at[0] < fillet.a);
    const bool leaves_b = takes_b || is_closed(b) || fillet.goes_on_b == (kept.at[1] > fillet.b);
    if (!leaves_a || !leaves_b) continue;
    const double away = kept.away(fillet.a, fillet.b);
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

std::optional<CurveIntersection> corner_beside(const NurbsCurve& a, const NurbsCurve& b, const KeptPlaces& kept) {
  const CurveIntersections both = intersections(a, b);
  if (!both.overlaps.empty()) throw InvalidShape("the curves coincide along a segment: they make no corner");
  std::optional<CurveIntersection> found;
  for (const CurveIntersection& place : both.places) {
    if (found && kept.away(place.a, place.b) >= kept.away(found->a, found->b)) continue;
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

/// Twice as far as the control points are apart at least, which turning both does not change.
double size_of_both(const NurbsCurve& a, const NurbsCurve& b) {
  std::vector<glm::dvec3> places;
  for (const NurbsCurve* const curve : {&a, &b}) {
    for (const glm::dvec4& point : curve->points()) {
      if (point.w != 0.0) places.emplace_back(point);
    }
  }
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : places) middle += place / static_cast<double>(places.size());
  double farthest = 0.0;
  for (const glm::dvec3& place : places) farthest = std::max(farthest, distance_of(place, middle));
  return 4.0 * farthest;
}

void require_inside(const NurbsCurve& curve, double u) {
  if (u >= curve.domain().start && u <= curve.domain().end) return;
  throw InvalidShape("kept = " + text_of(u) + " is outside of the curve's domain");
}

KeptPlaces kept_places(const NurbsCurve& a, const NurbsCurve& b, const std::array<double, 2>& kept) {
  require_inside(a, kept[0]);
  require_inside(b, kept[1]);
  return {kept, {a.domain().length(), b.domain().length()}};
}

}  // namespace

CornerBetween filleted(const NurbsCurve& a, const NurbsCurve& b, double radius, const std::array<double, 2>& kept,
                       const glm::dvec3& normal) {
  const KeptPlaces places = kept_places(a, b, kept);
  const auto made = [&](const NurbsCurve& of_a, const NurbsCurve& of_b) -> std::optional<CornerBetween> {
    const std::optional<Fillet> fillet = fillet_beside(of_a, of_b, radius, places, normal);
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
  const KeptPlaces places = kept_places(a, b, kept);
  for (const double length : lengths) {
    if (!(length >= 0.0) || !std::isfinite(length)) throw InvalidShape("a length is not 0 or more");
  }
  if (lengths[0] == 0.0 && lengths[1] == 0.0) throw InvalidShape("both lengths are 0: there is nothing to chamfer");
  const auto made = [&](const NurbsCurve& of_a, const NurbsCurve& of_b) -> std::optional<CornerBetween> {
    const std::optional<CurveIntersection> corner = corner_beside(of_a, of_b, places);
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
