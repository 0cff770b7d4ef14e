#include "splinecore/build/touching_circle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/rounding.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/conic/plane.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// A place of a curve in the coordinates of the plane, its unit tangent, and how the circle's side of it moves.
struct SidePlace {
  glm::dvec2 point;
  glm::dvec2 tangent;
  double speed;
  double curvature;

  glm::dvec2 left() const { return {-tangent.y, tangent.x}; }
};

SidePlace place_on(const NurbsCurve& curve, double u, const Plane& plane) {
  std::array<glm::dvec3, 3> d;
  derivatives(curve, std::span(&u, 1), 2, std::span(&d[0].x, 9));
  const glm::dvec2 first = direction_in(plane, d[1]);
  const glm::dvec2 second = direction_in(plane, d[2]);
  const double speed = glm::length(first);
  return {point_in(plane, d[0]), first / speed, speed, (first.x * second.y - first.y * second.x) / (speed * speed * speed)};
}

/// The center of a circle through three points.
glm::dvec2 center_of(const std::array<SidePlace, 3>& places) {
  const glm::dvec2 a = places[1].point - places[0].point;
  const glm::dvec2 b = places[2].point - places[0].point;
  const double area = 2.0 * (a.x * b.y - a.y * b.x);
  constexpr double kFlat = 0x1p-40;
  if (!(std::abs(area) > kFlat * glm::length(a) * glm::length(b))) {
    throw InvalidShape("the places on the three curves are on one line: no circle goes through them");
  }
  const double aa = glm::dot(a, a);
  const double bb = glm::dot(b, b);
  return places[0].point + glm::dvec2(aa * b.y - bb * a.y, bb * a.x - aa * b.x) / area;
}

class ThreeTouches {
 public:
  ThreeTouches(const std::array<NurbsCurve, 3>& curves, const std::array<double, 3>& near, const Plane& plane)
      : curves_(curves), plane_(plane), at_(near) {
    look();
    center_ = center_of(places_);
    radius_ = glm::distance(center_, places_[0].point);
    for (std::size_t i = 0; i < 3; ++i) {
      sides_[i] = glm::dot(center_ - places_[i].point, places_[i].left()) < 0.0 ? -1.0 : 1.0;
    }
  }

  /// @returns whether it found where the circle touches all
  bool solve() {
    constexpr int kMost = 60;
    constexpr double kReached = 1e-13;   // by the radius
    constexpr double kNear = 1e-10;
    for (int round = 0; round < kMost; ++round) {
      breathe(1024);
      if (!step()) return false;
      look();
      if (rest() <= kReached * radius_ + kRoundingOfStep * size()) return radius_ > 0.0;
    }
    return rest() <= kNear * radius_ + kRoundingOfStep * size() && radius_ > 0.0;
  }

  glm::dvec2 center() const { return center_; }
  double radius() const { return radius_; }
  const std::array<double, 3>& parameters() const { return at_; }
  const std::array<SidePlace, 3>& places() const { return places_; }

 private:
  void look() {
    for (std::size_t i = 0; i < 3; ++i) places_[i] = place_on(curves_[i], at_[i], plane_);
  }

  /// From where the center would be beside a curve to where it is.
  glm::dvec2 gap(std::size_t i) const {
    return center_ - places_[i].point - sides_[i] * radius_ * places_[i].left();
  }

  /// What is rounded where the circle is.
  double size() const {
    double largest = std::max(std::abs(center_.x), std::abs(center_.y));
    for (const SidePlace& place : places_) largest = std::max({largest, std::abs(place.point.x), std::abs(place.point.y)});
    return largest;
  }

  double rest() const { return std::max({glm::length(gap(0)), glm::length(gap(1)), glm::length(gap(2))}); }

  /// Across each curve there are three equations for the center and the radius; what is left along it moves its place.
  bool step() {
    glm::dmat3 rows;
    glm::dvec3 right;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const glm::dvec2 left = places_[k].left();
      rows[0][i] = left.x;
      rows[1][i] = left.y;
      rows[2][i] = -sides_[k];
      right[i] = -glm::dot(gap(k), left);
    }
    const double volume = glm::determinant(rows);
    constexpr double kParallel = 0x1p-46;  // of rows of length about 1: the three directions say nothing of the circle
    if (!(std::abs(volume) > kParallel)) return false;
    const glm::dvec3 by = glm::inverse(rows) * right;
    // No step goes farther than the circle is large, or turns it inside out.
    const double most = std::max(glm::length(glm::dvec2(by)), std::abs(by.z));
    const double share = most > 0.5 * radius_ ? 0.5 * radius_ / most : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double stretch = 1.0 - sides_[i] * radius_ * places_[i].curvature;
      const double along = glm::dot(gap(i) + glm::dvec2(by), places_[i].tangent);
      const Interval domain = curves_[i].domain();
      // Where the curve bends as the circle does, its foot may be anywhere: no farther than a step may go.
      const double way = stretch != 0.0 ? along / (places_[i].speed * stretch) : 0.0;
      at_[i] = std::clamp(at_[i] + share * std::clamp(way, -0.1 * domain.length(), 0.1 * domain.length()), domain.start,
                          domain.end);
    }
    center_ += share * glm::dvec2(by);
    radius_ += share * by.z;
    return std::isfinite(radius_);
  }

  const std::array<NurbsCurve, 3>& curves_;
  const Plane& plane_;
  std::array<double, 3> at_;
  std::array<SidePlace, 3> places_{};
  std::array<double, 3> sides_{};
  glm::dvec2 center_{};
  double radius_ = 0.0;
};

}  // namespace

TouchingCircle touching_circle(const std::array<NurbsCurve, 3>& curves, const std::array<double, 3>& near,
                               const glm::dvec3& normal) {
  std::vector<glm::dvec4> all;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval domain = curves[i].domain();
    if (!(near[i] >= domain.start && near[i] <= domain.end)) {
      throw InvalidShape("near[" + std::to_string(i) + "] = " + text_of(near[i]) + " is outside of the curve's domain");
    }
    all = together(all, curves[i].points());
  }
  const NearSpace space(all);
  std::array<NurbsCurve, 3> inner = curves;
  for (NurbsCurve& curve : inner) curve = curve.with_points(space.enter(curve.points()));
  const Plane plane = plane_across(glm::dvec3(0.0), normal);
  ThreeTouches touches(inner, near, plane);
  if (!touches.solve()) throw InvalidShape("no circle touches the three curves near there");
  std::array<glm::dvec3, 3> at;
  const double height = glm::dot(glm::dvec3(inner[0].points().front()), glm::cross(plane.x_axis, plane.y_axis));
  const glm::dvec3 lift = height * glm::cross(plane.x_axis, plane.y_axis);
  for (std::size_t i = 0; i < 3; ++i) at[i] = space.leave(plane.point(touches.places()[i].point) + lift);
  return {arc_through(at[0], at[1], at[2]), space.leave(plane.point(touches.center()) + lift),
          space.length(touches.radius()), touches.parameters()};
}

}  // namespace splinecore
