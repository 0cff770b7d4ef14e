#include "hole_plane.hpp"

#include <algorithm>
#include <cstddef>

#include "base/length.hpp"

namespace splinecore {

std::vector<HolePlace> places_along(const HoleSide& side) {
  constexpr int kPlaces = 17;
  std::vector<double> s;
  for (int k = 0; k < kPlaces; ++k) s.push_back(static_cast<double>(k) / (kPlaces - 1));
  return side.places(s);
}

std::optional<HolePlane> plane_of(const std::vector<std::vector<HolePlace>>& sides) {
  constexpr double kFlat = 1e-3;
  std::vector<glm::dvec3> points;
  for (const auto& side : sides) {
    for (std::size_t k = 0; k + 1 < side.size(); ++k) points.push_back(side[k].point);
  }
  HolePlane plane{glm::dvec3(0.0), {}, {}, glm::dvec3(0.0), 0.0};
  for (const glm::dvec3& p : points) plane.origin += p / static_cast<double>(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    plane.normal += glm::cross(points[k] - plane.origin, points[(k + 1) % points.size()] - plane.origin);
    plane.size = std::max(plane.size, length_of(points[k] - plane.origin));
  }
  const double area = length_of(plane.normal);
  if (!(area > kFlat * plane.size * plane.size)) return {};
  plane.normal /= area;
  const glm::dvec3 way = points[0] - plane.origin - glm::dot(points[0] - plane.origin, plane.normal) * plane.normal;
  if (!(length_of(way) > kFlat * plane.size)) return {};
  plane.x = way / length_of(way);
  plane.y = glm::cross(plane.normal, plane.x);
  return plane;
}

}  // namespace splinecore
