#include "splinecore/build/fillet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/printable.hpp"
#include "base/sort_by.hpp"
#include "meet/near_space.hpp"
#include "beside_both.hpp"
#include "crossing_search.hpp"
#include "curve_ends.hpp"
#include "offset_parts.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/meet/stationary.hpp"

namespace splinecore {

namespace {

/// Parameters at which a circle about a place, of about this radius, may touch a curve: all, not the nearest alone, for where a
/// curve bends more than the circle it lies on both sides of it.
std::vector<double> touching_parameters(const NurbsCurve& curve, const glm::dvec3& center, double radius) {
  constexpr double kAbout = 0x1p-7;
  std::vector<double> found;
  NearestOnCurve first;
  nearest(curve, std::span(&center, 1), std::span(&first, 1), 1);
  found.push_back(first.parameter);
  try {
    for (const StationaryOnCurve& place : stationary_points(curve, center)) {
      if (std::abs(place.distance - radius) <= kAbout * radius) found.push_back(place.parameter);
    }
  } catch (const InvalidShape&) {
    // A part of it is an arc about that center: any place of it is as good as the nearest one.
    return found;
  }
  return found;
}

/// A place that two offsets have in common: where they cross, or the end of a stretch.
struct CommonPlace {
  glm::dvec3 at;
  bool is_of_stretch;
};

/// All fillets with their centers at crossings of offsets.
class FilletSearch {
 public:
  FilletSearch(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal) : a_(a), b_(b), normal_(normal) {}

  /// @throws CrossingUndecided
  void look(double side_a, double side_b, const CommonPlace& place) {
    const glm::dvec3& center = place.at;
    const BesideBoth circle(a_, b_, normal_, {side_a, side_b});
    const double radius = std::abs(side_a);
    const std::vector<double> on_b = touching_parameters(b_, center, radius);
    bool is_sure = false;
    for (const double u : touching_parameters(a_, center, radius)) {
      for (const double v : on_b) {
        const auto made = circle.near(u, v);
        is_sure = is_sure || (made && (place.is_of_stretch || !(made->fillet && is_shallow(*made->fillet, radius))));
        if (made && made->fillet) add(*made->fillet, radius);
      }
    }
    if (is_sure) return;
    // Offsets are known within a tolerance only, and have arcs and lines at corners: a crossing may stand for no arc, or, of curves that
    // nearly touch, for two.
    for (const Fillet& made : CrossingSearch(a_, b_, normal_, {side_a, side_b}).near(center)) add(made, radius);
  }

  std::vector<Fillet> found() && { return std::move(found_); }

 private:
  /// Whether tangents at both ends are nearly one: there may be another such arc near it.
  static bool is_shallow(const Fillet& made, double radius) {
    constexpr double kShallow = 0x1p-4;
    const glm::dvec3 from = glm::dvec3(made.arc.points().front()) - made.center;
    const glm::dvec3 to = glm::dvec3(made.arc.points().back()) - made.center;
    return glm::length(glm::cross(from / radius, to / radius)) <= kShallow;
  }

  void add(const Fillet& made, double radius) {
    if (!is_known(made, radius)) found_.push_back(made);
  }

  /// About one center there may be several, where a curve touches the circle more than once.
  bool is_known(const Fillet& made, double radius) const {
    constexpr double kSame = 1e-9;
    constexpr double kSamePlace = 1e-6;  // where curves touch a circle, places on them are had to half the digits
    return std::ranges::any_of(found_, [&](const Fillet& other) {
      const auto apart = [](const glm::dvec4& p, const glm::dvec4& q) { return glm::distance(glm::dvec3(p), glm::dvec3(q)); };
      return glm::distance(other.center, made.center) <= kSame * radius &&
             apart(other.arc.points().front(), made.arc.points().front()) <= kSamePlace * radius &&
             apart(other.arc.points().back(), made.arc.points().back()) <= kSamePlace * radius;
    });
  }

  const NurbsCurve& a_;
  const NurbsCurve& b_;
  glm::dvec3 normal_;
  std::vector<Fillet> found_;
};

/// Where two offsets cross, and the ends of stretches that they have in common.
std::vector<CommonPlace> common_places(const NurbsCurve& of_a, const NurbsCurve& of_b) {
  const CurveIntersections common = intersections(of_a, of_b);
  std::vector<CommonPlace> found;
  for (const CurveIntersection& place : common.places) found.push_back({place.point, false});
  for (const CurveOverlap& stretch : common.overlaps) {
    found.push_back({point_at(of_a, stretch.a.start), true});
    found.push_back({point_at(of_a, stretch.a.end), true});
  }
  return found;
}

/// Looks where offsets cross; and, for offsets are known within a tolerance only, where one of them crosses others that are as much
/// nearer or farther as lets none of those that nearly touch be left out.
void look_beside(const NurbsCurve& a, const NurbsCurve& b, const std::array<double, 2>& sides, const OffsetOptions& beside,
                 FilletSearch& search) {
  constexpr double kMore = 0x1p-18;  // four times the tolerance of an offset
  const std::vector<NurbsCurve> beside_a = offset_parts(a, sides[0], beside);
  for (const double more : {0.0, kMore, -kMore}) {
    if (std::abs(more) >= std::abs(sides[1])) continue;
    for (const NurbsCurve& of_b : offset_parts(b, sides[1] + more, beside)) {
      for (const NurbsCurve& of_a : beside_a) {
        for (const CommonPlace& place : common_places(of_a, of_b)) search.look(sides[0], sides[1], place);
      }
    }
  }
}

}  // namespace

std::vector<Fillet> fillets(const NurbsCurve& given_a, const NurbsCurve& given_b, double given_radius,
                            const glm::dvec3& normal) {
  if (!(given_radius > 0.0) || !std::isfinite(given_radius)) throw InvalidShape("the radius is not above 0");
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("the normal is zero or not finite");
  const glm::dvec3 up = normal / length;
  // Far from the origin their own digits would be lost in those of the place.
  const NearSpace space(together(given_a.points(), given_b.points()));
  const NurbsCurve a = given_a.with_points(space.enter(given_a.points()));
  const NurbsCurve b = given_b.with_points(space.enter(given_b.points()));
  const double radius = given_radius / space.length(1.0);
  OffsetOptions beside;
  beside.normal = up;
  FilletSearch search(a, b, up);
  try {
    for (const double side_a : {radius, -radius}) {
      for (const double side_b : {radius, -radius}) look_beside(a, b, {side_a, side_b}, beside, search);
    }
  } catch (const CrossingUndecided& open) {
    throw InvalidShape("whether an arc of the radius about " + place_text(space.leave(open.center)) +
                       " touches both curves is not told: they run beside each other there for very long");
  }
  std::vector<Fillet> found = std::move(search).found();
  for (Fillet& fillet : found) {
    fillet.arc = fillet.arc.with_points(space.leave(fillet.arc.points()));
    fillet.center = space.leave(fillet.center);
  }
  sort_by(found, [](const Fillet& fillet) { return SortKey{fillet.a, fillet.b}; });
  return found;
}

}  // namespace splinecore
