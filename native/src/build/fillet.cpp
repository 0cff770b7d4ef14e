#include "splinecore/build/fillet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/sort_by.hpp"
#include "meet/near_space.hpp"
#include "offset_parts.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/intersections.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/meet/stationary.hpp"

namespace splinecore {

namespace {

/// A place of a curve, the unit tangent, the point beside it, and how that goes by the parameter.
struct BesidePlace {
  glm::dvec3 point;
  glm::dvec3 tangent;
  glm::dvec3 centre;
  glm::dvec3 slope;
};

/// Two curves, and on which side of each the centre is.
class BesideBoth {
 public:
  BesideBoth(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal, const std::array<double, 2>& sides)
      : a_(a), b_(b), normal_(normal), sides_(sides) {}

  /// Newton's method for where the points beside both curves are one.
  std::optional<Fillet> near(double u, double v) const {
    constexpr int kMost = 40;
    const std::array<Interval, 2> domains{a_.domain(), b_.domain()};
    std::array<double, 2> before{domains[0].length(), domains[1].length()};
    for (int round = 0; round < kMost; ++round) {
      breathe(1024);
      const BesidePlace on_a = place(a_, u, sides_[0]);
      const BesidePlace on_b = place(b_, v, sides_[1]);
      const glm::dvec3 gap = on_b.centre - on_a.centre;
      const double area = glm::dot(glm::cross(on_a.slope, on_b.slope), normal_);
      if (!(std::abs(area) > 0.0)) return {};
      const double by_u = glm::dot(glm::cross(gap, on_b.slope), normal_) / area;
      const double by_v = glm::dot(glm::cross(gap, on_a.slope), normal_) / area;
      const double next_u = std::clamp(u + by_u, domains[0].start, domains[0].end);
      const double next_v = std::clamp(v + by_v, domains[1].start, domains[1].end);
      const std::array<double, 2> steps{std::abs(next_u - u), std::abs(next_v - v)};
      u = next_u;
      v = next_v;
      constexpr double kStill = 0x1p-50;
      const bool is_still = steps[0] <= kStill * domains[0].length() && steps[1] <= kStill * domains[1].length();
      const bool is_noise = round > 4 && steps[0] >= before[0] && steps[1] >= before[1];
      if (is_still || is_noise) return fillet(u, v);
      before = steps;
    }
    return {};
  }

 private:
  BesidePlace place(const NurbsCurve& curve, double u, double side) const {
    std::array<glm::dvec3, 3> d;
    derivatives(curve, std::span(&u, 1), 2, std::span(&d[0].x, 9));
    const double speed = glm::length(d[1]);
    const glm::dvec3 tangent = d[1] / speed;
    const double curvature = glm::dot(glm::cross(tangent, d[2] / speed), normal_) / speed;
    return {d[0], tangent, d[0] + side * glm::cross(normal_, tangent), (1.0 - side * curvature) * d[1]};
  }

  /// How far the place beside a curve goes between two parameters that follow each other as numbers.
  static double rounding_of(const BesidePlace& place, double u) {
    constexpr double kFew = 0x1p-50;
    return kFew * std::abs(u) * glm::length(place.slope);
  }

  std::optional<Fillet> fillet(double u, double v) const {
    constexpr double kOff = 1e-9;
    const BesidePlace on_a = place(a_, u, sides_[0]);
    const BesidePlace on_b = place(b_, v, sides_[1]);
    const double radius = std::abs(sides_[0]);
    const glm::dvec3 centre = 0.5 * (on_a.centre + on_b.centre);
    const double room = kOff * radius + rounding_of(on_a, u) + rounding_of(on_b, v);
    if (!(glm::distance(on_a.centre, on_b.centre) <= room)) return {};
    if (!(glm::distance(on_a.point, on_b.point) > kOff * radius)) return {};
    const glm::dvec3 from = on_a.point - centre;
    const glm::dvec3 to = on_b.point - centre;
    const double turn = glm::dot(glm::cross(from / radius, to / radius), normal_) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 start = turn * glm::cross(normal_, from);
    const glm::dvec3 end = turn * glm::cross(normal_, to);
    return Fillet{arc_about(centre, on_a.point, on_b.point, turn * normal_), u, v, centre,
                  glm::dot(start, on_a.tangent) > 0.0, glm::dot(end, on_b.tangent) > 0.0};
  }

  const NurbsCurve& a_;
  const NurbsCurve& b_;
  glm::dvec3 normal_;
  std::array<double, 2> sides_;
};

/// Parameters at which a circle about a place, of about this radius, may touch a curve: all, not the nearest alone, for where a
/// curve bends more than the circle it lies on both sides of it.
std::vector<double> touching_parameters(const NurbsCurve& curve, const glm::dvec3& centre, double radius) {
  constexpr double kAbout = 0x1p-7;
  std::vector<double> found;
  NearestOnCurve first;
  nearest(curve, std::span(&centre, 1), std::span(&first, 1), 1);
  found.push_back(first.parameter);
  try {
    for (const StationaryOnCurve& place : stationary_points(curve, centre)) {
      if (std::abs(place.distance - radius) <= kAbout * radius) found.push_back(place.parameter);
    }
  } catch (const InvalidShape&) {
    // A part of it is an arc about that centre: any place of it is as good as the nearest one.
    return found;
  }
  return found;
}

/// All fillets with their centres at crossings of offsets.
class FilletSearch {
 public:
  FilletSearch(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal) : a_(a), b_(b), normal_(normal) {}

  void look(double side_a, double side_b, const glm::dvec3& centre) {
    const BesideBoth circle(a_, b_, normal_, {side_a, side_b});
    const double radius = std::abs(side_a);
    const std::vector<double> on_b = touching_parameters(b_, centre, radius);
    for (const double u : touching_parameters(a_, centre, radius)) {
      for (const double v : on_b) {
        const auto made = circle.near(u, v);
        if (made && !is_known(*made, radius)) found_.push_back(*made);
      }
    }
  }

  std::vector<Fillet> found() && { return std::move(found_); }

 private:
  /// About one centre there may be several, where a curve touches the circle more than once.
  bool is_known(const Fillet& made, double radius) const {
    constexpr double kSame = 1e-9;
    constexpr double kSamePlace = 1e-6;  // where curves touch a circle, places on them are had to half the digits
    return std::ranges::any_of(found_, [&](const Fillet& other) {
      const auto apart = [](const glm::dvec4& p, const glm::dvec4& q) { return glm::distance(glm::dvec3(p), glm::dvec3(q)); };
      return glm::distance(other.centre, made.centre) <= kSame * radius &&
             apart(other.arc.points().front(), made.arc.points().front()) <= kSamePlace * radius &&
             apart(other.arc.points().back(), made.arc.points().back()) <= kSamePlace * radius;
    });
  }

  const NurbsCurve& a_;
  const NurbsCurve& b_;
  glm::dvec3 normal_;
  std::vector<Fillet> found_;
};

}  // namespace

std::vector<Fillet> fillets(const NurbsCurve& given_a, const NurbsCurve& given_b, double given_radius,
                            const glm::dvec3& normal) {
  if (!(given_radius > 0.0) || !std::isfinite(given_radius)) throw InvalidShape("the radius is not above 0");
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length)) throw InvalidShape("the normal is zero or no vector of numbers");
  const glm::dvec3 up = normal / length;
  // Far from the origin their own digits would be lost in those of the place.
  const NearSpace space(together(given_a.points(), given_b.points()));
  const NurbsCurve a = given_a.with_points(space.enter(given_a.points()));
  const NurbsCurve b = given_b.with_points(space.enter(given_b.points()));
  const double radius = given_radius / space.length(1.0);
  OffsetOptions beside;
  beside.normal = up;
  FilletSearch search(a, b, up);
  for (const double side_a : {radius, -radius}) {
    const std::vector<NurbsCurve> beside_a = offset_parts(a, side_a, beside);
    for (const double side_b : {radius, -radius}) {
      for (const NurbsCurve& of_b : offset_parts(b, side_b, beside)) {
        for (const NurbsCurve& of_a : beside_a) {
          for (const CurveIntersection& place : intersections(of_a, of_b).places) search.look(side_a, side_b, place.point);
        }
      }
    }
  }
  std::vector<Fillet> found = std::move(search).found();
  for (Fillet& fillet : found) {
    fillet.arc = fillet.arc.with_points(space.leave(fillet.arc.points()));
    fillet.centre = space.leave(fillet.centre);
  }
  sort_by(found, [](const Fillet& fillet) { return SortKey{fillet.a, fillet.b}; });
  return found;
}

}  // namespace splinecore
