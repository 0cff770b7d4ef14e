#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

namespace splinecore {

/// A plane with coordinates: an origin and two orthonormal axes. The default is the xy plane.
struct Plane {
  glm::dvec3 origin{0.0, 0.0, 0.0};
  glm::dvec3 x_axis{1.0, 0.0, 0.0};
  glm::dvec3 y_axis{0.0, 1.0, 0.0};

  glm::dvec3 point(const glm::dvec2& p) const noexcept { return origin + p.x * x_axis + p.y * y_axis; }
  glm::dvec3 direction(const glm::dvec2& v) const noexcept { return v.x * x_axis + v.y * y_axis; }
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// The plane through a point along two directions. Axes that are orthonormal up to rounding are
/// taken as they are; otherwise x is made a unit vector and y is turned at right angles to it.
/// @throws InvalidShape naming the argument if one is zero, parallel to the other or not finite.
Plane plane_along(const glm::dvec3& origin, const glm::dvec3& x_axis, const glm::dvec3& y_axis);

/// The plane at right angles to a normal, with axes by the rule of DXF files: where the normal is
/// +z they are x and y.
/// @throws InvalidShape if the normal is zero or not finite.
Plane plane_across(const glm::dvec3& origin, const glm::dvec3& normal);

/// The plane of points that lie in one up to `tolerance`, with its origin in their middle. A plane
/// parallel to xy has the axes x and y.
/// @throws InvalidShape naming the farthest point if they do not, or lie on one line.
Plane plane_of(std::span<const glm::dvec3> points, double tolerance);

/// The plane of three points given as (x, y, z, w), w = 0 for a direction: the xy plane itself
/// where every z is 0. Nothing where they span none: they lie on a line, up to rounding, or all are directions.
std::optional<Plane> plane_of_control_points(std::span<const glm::dvec4> points);

/// The plane's coordinates of a point and of a direction.
glm::dvec2 point_in(const Plane& plane, const glm::dvec3& point) noexcept;
glm::dvec2 direction_in(const Plane& plane, const glm::dvec3& direction) noexcept;

}  // namespace splinecore
