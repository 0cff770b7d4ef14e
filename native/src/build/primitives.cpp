#include "splinecore/build/primitives.hpp"

#include <cmath>
#include <numbers>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/conic/plane.hpp"
#include "spokes.hpp"

namespace splinecore {

namespace {

void require_not_negative(double length, const char* name) {
  if (length >= 0.0 && std::isfinite(length)) return;
  throw InvalidShape(std::string(name) + " = " + text_of(length) + " is not a length");
}

/// Where a body of revolution stands.
struct Stand {
  Plane across;
  glm::dvec3 axis;

  Stand(const glm::dvec3& center, const glm::dvec3& direction) {
    require_place(center, "center");
    const double length = require_length(direction, "axis");
    axis = direction / length;
    across = plane_across(center, axis);
  }

  Spoke spoke(double radius, double height, double weight = 1.0) const {
    return {across.origin + height * axis, radius * across.x_axis, radius * across.y_axis, weight};
  }

  /// The spokes of a curve of (radius, height).
  std::vector<Spoke> spokes(const NurbsCurve& profile) const {
    std::vector<Spoke> all;
    for (const glm::dvec4& p : profile.points()) all.push_back(spoke(p.x, p.y, p.w));
    return all;
  }
};

/// The mantle between two circles.
NurbsPatch frustum(const Stand& stand, double radius, double top_radius, double height, const Turn& turn) {
  return turned(KnotVector::bezier(1), {stand.spoke(radius, 0.0), stand.spoke(top_radius, height)}, turn);
}

}  // namespace

NurbsPatch plane(const glm::dvec3& origin, const glm::dvec3& axis_a, const glm::dvec3& axis_b) {
  require_place(origin, "origin");
  const glm::dvec3 a = axis_a / require_length(axis_a, "axis_a");
  const glm::dvec3 b = axis_b / require_length(axis_b, "axis_b");
  try {
    plane_along(origin, a, b);
  } catch (const InvalidShape&) {
    throw InvalidShape("axis_b is parallel to axis_a: they span no plane");
  }
  const auto corner = [&](double u, double v) { return glm::dvec4(origin + (u * axis_a + v * axis_b), 1.0); };
  return NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1),
                          {corner(0, 0), corner(0, 1), corner(1, 0), corner(1, 1)});
}

NurbsPatch cylinder(const glm::dvec3& center, const glm::dvec3& axis, double radius, double height, Turn turn) {
  require_positive(radius, "radius");
  require_positive(height, "height");
  return frustum(Stand(center, axis), radius, radius, height, turn);
}

NurbsPatch cone(const glm::dvec3& center, const glm::dvec3& axis, double radius, double height, double top_radius,
                Turn turn) {
  require_not_negative(radius, "radius");
  require_not_negative(top_radius, "top_radius");
  require_positive(height, "height");
  if (radius == 0.0 && top_radius == 0.0) throw InvalidShape("radius and top_radius are both 0: the cone is a line");
  return frustum(Stand(center, axis), radius, top_radius, height, turn);
}

NurbsPatch disc(const glm::dvec3& center, const glm::dvec3& axis, double radius, Turn turn) {
  require_positive(radius, "radius");
  return frustum(Stand(center, axis), radius, 0.0, 0.0, turn);
}

NurbsPatch sphere(const glm::dvec3& center, double radius, const glm::dvec3& axis, Turn turn) {
  require_positive(radius, "radius");
  const Stand stand(center, axis);
  const NurbsCurve meridian = ellipse_arc(glm::dvec3(0.0), {radius, 0.0, 0.0}, {0.0, radius, 0.0},
                                          -0.5 * std::numbers::pi, std::numbers::pi);
  return turned(meridian.knot_vector(), stand.spokes(meridian), turn);
}

NurbsPatch torus(const glm::dvec3& center, const glm::dvec3& axis, double ring_radius, double tube_radius, Turn turn) {
  require_positive(ring_radius, "ring_radius");
  require_positive(tube_radius, "tube_radius");
  const Stand stand(center, axis);
  const NurbsCurve tube =
      closed_ring(ellipse({ring_radius, 0.0, 0.0}, {tube_radius, 0.0, 0.0}, {0.0, tube_radius, 0.0}));
  return turned(tube.knot_vector(), stand.spokes(tube), turn);
}

}  // namespace splinecore
