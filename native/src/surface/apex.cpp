#include "apex.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/length.hpp"
#include "hole_plane.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

bool has_neighbour(const HolePlace& place) { return place.out != glm::dvec3(0.0); }

/// c + factor (rise . way) = height: what a place says of the apex, by its height over the plane and the rise there.
struct Expectation {
  glm::dvec3 way;  ///< in the plane, from its origin to the place
  double factor;
  double height;
};

Expectation expectation_at(const HolePlace& place, const HolePlane& plane) {
  constexpr double kSteepest = 12.0;  // of tan(angle / 2)
  const glm::dvec3 off = place.point - plane.origin;
  const double height = glm::dot(off, plane.normal);
  const glm::dvec3 way = off - height * plane.normal;
  if (!has_neighbour(place)) return {way, 1.0, height};
  const glm::dvec3 across = place.out - place.along * (glm::dot(place.out, place.along) / glm::dot(place.along, place.along));
  const double rise = glm::dot(across, plane.normal);
  const double inwards = -glm::dot(across, way) / length_of(way);
  const double half = rise / std::max(std::hypot(rise, inwards) + inwards, std::abs(rise) / kSteepest);
  return {way, 0.5, height + (rise == 0.0 ? 0.0 : length_of(way) * half)};
}

/// The height of the apex over the plane and the slope of its tangent plane, by least squares.
Eigen::Vector3d solved(const std::vector<Expectation>& all, const HolePlane& plane) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> left(static_cast<Eigen::Index>(all.size()), 3);
  Eigen::VectorXd right(static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    left.row(row) << plane.size, all[i].factor * glm::dot(all[i].way, plane.x), all[i].factor * glm::dot(all[i].way, plane.y);
    right[row] = all[i].height;
  }
  Eigen::Vector3d found = left.colPivHouseholderQr().solve(right);
  found[0] *= plane.size;
  return found;
}

void require_seen(const std::vector<Expectation>& all, const HolePlane& plane) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::dvec3& next = all[(i + 1) % all.size()].way;
    if (glm::dot(glm::cross(all[i].way, next), plane.normal) > 0.0) continue;
    throw InvalidShape("the hole is round, but not seen whole from its middle: surfaces that run together there would fold");
  }
}

}  // namespace

glm::dvec3 leaving(const HolePlace& place, const glm::dvec3& apex) {
  const glm::dvec3 chord = apex - place.point;
  if (!has_neighbour(place)) return chord;
  glm::dvec3 normal = glm::cross(place.out, place.along);
  normal /= length_of(normal);
  const glm::dvec3 way = chord - normal * glm::dot(normal, chord);
  const double cosine = length_of(way) / length_of(chord);
  return way / cosine * (2.0 / (1.0 + cosine));
}

Apex apex_of(const Hole& hole) {
  std::vector<std::vector<HolePlace>> sides;
  for (const HoleSide& side : hole.sides) sides.push_back(places_along(side));
  const std::optional<HolePlane> plane = plane_of(sides);
  if (!plane) throw InvalidShape("the hole is round, but lies over no plane");
  std::vector<HolePlace> places;
  for (const auto& side : sides) places.insert(places.end(), side.begin(), side.end() - 1);
  std::vector<Expectation> all;
  for (const HolePlace& place : places) all.push_back(expectation_at(place, *plane));
  require_seen(all, *plane);
  const Eigen::Vector3d found = solved(all, *plane);
  Apex apex{plane->origin + found[0] * plane->normal, plane->normal, found[1] * plane->x + found[2] * plane->y};
  double sum = 0.0;
  for (const HolePlace& place : places) sum += length_of(leaving(place, apex.point)) / length_of(apex.arriving(place.point));
  apex.speed = sum / static_cast<double>(places.size());
  return apex;
}

}  // namespace splinecore
