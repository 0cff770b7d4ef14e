#include "splinecore/conic/plane.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// Unit vectors come back bit for bit, so that a plane can be made again from its axes.
glm::dvec3 unit(const glm::dvec3& v, const char* name) {
  require_vector(v, name);
  const double length = length_of(v);
  if (!std::isnormal(length)) {
    throw InvalidShape(std::string(name) + " has no direction: its length is " + text_of(length));
  }
  return std::abs(length - 1.0) <= 4.0 * kEpsilon ? v : v / length;
}

struct Farthest {
  std::size_t index = 0;
  double distance = -1.0;
};

template <class Distance>
Farthest farthest(std::span<const glm::dvec3> points, Distance distance) {
  Farthest found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double here = distance(points[i]);
    if (here > found.distance) found = {i, here};
  }
  return found;
}

/// A unit vector, or zero, and by how much rounding of the points may turn it.
struct Leg {
  glm::dvec3 direction;
  double rounding;
};

/// Two directions from a finite point that span the plane of three points.
struct Spanning {
  glm::dvec3 origin;
  Leg a;
  Leg b;
};

Spanning spanning(std::span<const glm::dvec4> points) {
  const auto base = static_cast<std::size_t>(
      std::ranges::find_if(points, [](const glm::dvec4& p) { return p.w != 0.0; }) - points.begin());
  const double rounding = 4.0 * kEpsilon * largest_coordinate(points);
  const auto from_base = [&](std::size_t i) -> Leg {
    const glm::dvec4& p = points[(base + i) % 3];
    const glm::dvec3 leg = p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) - glm::dvec3(points[base]);
    const double length = length_of(leg);
    if (!std::isnormal(length)) return {glm::dvec3(0.0), 0.0};
    return {leg / length, p.w == 0.0 ? 0.0 : rounding / length};
  };
  return {glm::dvec3(points[base]), from_base(1), from_base(2)};
}

bool is_flat_xy(std::span<const glm::dvec3> points) {
  return std::ranges::all_of(points, [&](const glm::dvec3& p) { return p.z == points[0].z; });
}

}  // namespace

Plane plane_along(const glm::dvec3& origin, const glm::dvec3& x_axis, const glm::dvec3& y_axis) {
  require_vector(origin, "origin");
  const glm::dvec3 x = unit(x_axis, "x_axis");
  const glm::dvec3 y = unit(y_axis, "y_axis");
  const double cosine = glm::dot(x, y);
  if (std::abs(cosine) <= 4.0 * kEpsilon) return {origin, x, y};
  const glm::dvec3 across = y - cosine * x;
  if (length_of(across) <= 16.0 * kEpsilon) throw InvalidShape("y_axis is parallel to x_axis: they span no plane");
  // Once more, because the first step leaves a rest where the axes are nearly parallel.
  const glm::dvec3 once = across / length_of(across);
  return {origin, x, glm::normalize(once - glm::dot(x, once) * x)};
}

Plane plane_across(const glm::dvec3& origin, const glm::dvec3& normal) {
  constexpr double kNearlyVertical = 1.0 / 64.0;
  const glm::dvec3 n = unit(normal, "normal");
  const bool is_vertical = std::abs(n.x) < kNearlyVertical && std::abs(n.y) < kNearlyVertical;
  const glm::dvec3 x = glm::normalize(glm::cross(is_vertical ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), n));
  return plane_along(origin, x, glm::cross(n, x));
}

Plane plane_of(std::span<const glm::dvec3> points, double tolerance) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
  const glm::dvec3 start = points[0];
  const Farthest other = farthest(points, [&](const glm::dvec3& p) { return length_of(p - start); });
  if (!(other.distance > tolerance)) throw InvalidShape("points all lie in one place");
  const glm::dvec3 along = (points[other.index] - start) / other.distance;
  const auto across = [&](const glm::dvec3& p) { return glm::cross(along, p - start); };
  const Farthest third = farthest(points, [&](const glm::dvec3& p) { return length_of(across(p)); });
  if (!(third.distance > tolerance)) throw InvalidShape("points all lie on one line");
  const glm::dvec3 normal = across(points[third.index]) / third.distance;
  const auto height = [&](const glm::dvec3& p) { return std::abs(glm::dot(p - start, normal)); };
  const Farthest above = farthest(points, height);
  if (above.distance > tolerance) {
    throw InvalidShape("points" + index_text(above.index) + " lies " + text_of(above.distance) +
                       " off the plane of others, more than the tolerance " + text_of(tolerance));
  }
  if (is_flat_xy(points)) return {middle, {1, 0, 0}, {0, 1, 0}};
  return plane_along(middle, along, glm::cross(normal, along));
}

std::optional<Plane> plane_of_control_points(std::span<const glm::dvec4> points) {
  if (std::ranges::all_of(points, [](const glm::dvec4& p) { return p.w == 0.0; })) return std::nullopt;
  const Spanning s = spanning(points);
  const double sine = length_of(accurate_cross(s.a.direction, s.b.direction));
  if (!(sine > 32.0 * kEpsilon + s.a.rounding + s.b.rounding)) return std::nullopt;
  if (std::ranges::all_of(points, [](const glm::dvec4& p) { return p.z == 0.0; })) return Plane{};
  return plane_along(s.origin, s.a.direction, s.b.direction);
}

glm::dvec2 direction_in(const Plane& plane, const glm::dvec3& direction) noexcept {
  return {glm::dot(direction, plane.x_axis), glm::dot(direction, plane.y_axis)};
}

glm::dvec2 point_in(const Plane& plane, const glm::dvec3& point) noexcept {
  return direction_in(plane, point - plane.origin);
}

}  // namespace splinecore
