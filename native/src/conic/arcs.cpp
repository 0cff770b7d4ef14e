#include "splinecore/conic/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"

namespace splinecore {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Sines so small are rounding.
constexpr double kStraight = 0x1p-46;

void require_finite(std::initializer_list<glm::dvec3> points) {
  for (const glm::dvec3& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) throw InvalidShape("a coordinate is not a finite number");
  }
}

/// A unit vector and a length, whatever its size.
struct Stretched {
  glm::dvec3 along{0.0};
  double length = 0.0;
};

Stretched measured(const glm::dvec3& v) {
  const glm::dvec3 steps = glm::abs(v);
  const double most = std::max({steps.x, steps.y, steps.z});
  if (!(most > 0.0)) return {};
  const glm::dvec3 scaled = v / most;
  const double length = glm::length(scaled);
  return {scaled / length, length * most};
}

/// From `start` with that unit tangent round to where `end` is.
NurbsCurve arc_of(const glm::dvec3& start, const glm::dvec3& tangent, const glm::dvec3& end, const Stretched& chord) {
  const glm::dvec3 across = chord.along - glm::dot(chord.along, tangent) * tangent;
  const double sine = glm::length(across);
  if (!(sine > kStraight)) throw InvalidShape("the direction is that of the line between both points");
  // The chord makes half the angle of the arc with the tangent.
  const double angle = std::atan2(sine, glm::dot(chord.along, tangent));
  const double radius = 0.5 * chord.length / sine;
  const glm::dvec3 to_center = across / sine;
  const NurbsCurve arc = ellipse_arc(start + radius * to_center, -radius * to_center, radius * tangent, 0.0, 2.0 * angle);
  std::vector<glm::dvec4> points(arc.points().begin(), arc.points().end());
  points.front() = glm::dvec4(start, points.front().w);
  points.back() = glm::dvec4(end, points.back().w);
  return arc.with_points(std::move(points));
}

}  // namespace

NurbsCurve arc_through(const glm::dvec3& start, const glm::dvec3& through, const glm::dvec3& end) {
  require_finite({start, through, end});
  const Stretched first = measured(through - start);
  const Stretched second = measured(end - through);
  const Stretched chord = measured(end - start);
  if (first.length == 0.0 || second.length == 0.0 || chord.length == 0.0) throw InvalidShape("two of the points coincide");
  const glm::dvec3 normal = glm::cross(first.along, second.along);
  const double sine = glm::length(normal);
  if (!(sine > kStraight)) throw InvalidShape("the points are on one line");
  // Between the chord to a point and the tangent there is the angle that the other chords make there.
  const double angle = std::atan2(sine, glm::dot(first.along, second.along));
  const glm::dvec3 inner = chord.along;
  const glm::dvec3 beside = glm::cross(normal / sine, inner);
  return arc_of(start, std::cos(angle) * inner - std::sin(angle) * beside, end, chord);
}

NurbsCurve arc_from_tangent(const glm::dvec3& start, const glm::dvec3& tangent, const glm::dvec3& end) {
  require_finite({start, tangent, end});
  const Stretched way = measured(tangent);
  const Stretched chord = measured(end - start);
  if (way.length == 0.0) throw InvalidShape("the direction is zero");
  if (chord.length == 0.0) throw InvalidShape("both points coincide");
  return arc_of(start, way.along, end, chord);
}

NurbsCurve arc_about(const glm::dvec3& center, const glm::dvec3& start, const glm::dvec3& end, const glm::dvec3& normal) {
  require_finite({center, start, end, normal});
  const Stretched radius = measured(start - center);
  const Stretched to_end = measured(end - center);
  if (radius.length == 0.0 || to_end.length == 0.0) throw InvalidShape("a point is the center");
  const Stretched given = measured(normal);
  const Stretched axis = measured(given.along - glm::dot(given.along, radius.along) * radius.along);
  if (!(axis.length > kStraight)) throw InvalidShape("the normal is zero or along the radius");
  const glm::dvec3 y = glm::cross(axis.along, radius.along);
  double angle = std::atan2(glm::dot(to_end.along, y), glm::dot(to_end.along, radius.along));
  if (angle <= kStraight) angle += kTurn;
  return ellipse_arc(center, radius.length * radius.along, radius.length * y, 0.0, std::min(angle, kTurn));
}

}  // namespace splinecore
