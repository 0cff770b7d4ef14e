#include "hole_plane.hpp"

#include <algorithm>
#include <cstddef>

#include "base/length.hpp"

namespace splinecore {

std::vector<HolePlace> places_along(const HoleSide& side, int count) {
  std::vector<double> s;
  for (int k = 0; k < count; ++k) s.push_back(static_cast<double>(k) / (count - 1));
  return side.places(s);
}

std::vector<double> lengths_at(const std::vector<HolePlace>& places) {
  const std::size_t last = places.size() - 1;
  std::vector<double> lengths;
  for (std::size_t k = 0; k <= last; ++k) {
    const double before = k > 0 ? distance_of(places[k - 1].point, places[k].point) : 0.0;
    const double after = k < last ? distance_of(places[k].point, places[k + 1].point) : 0.0;
    lengths.push_back(0.5 * (before + after));
  }
  return lengths;
}

std::optional<HolePlane> plane_of(const std::vector<std::vector<HolePlace>>& sides) {
  constexpr double kFlat = 1e-3;
  std::vector<glm::dvec3> points;
  HolePlane plane{glm::dvec3(0.0), {}, {}, glm::dvec3(0.0), 0.0};
  double length = 0.0;
  for (const auto& side : sides) {
    const std::vector<double> lengths = lengths_at(side);
    for (std::size_t k = 0; k < side.size(); ++k) {
      points.push_back(side[k].point);
      plane.origin += lengths[k] * side[k].point;
      length += lengths[k];
    }
  }
  if (!(length > 0.0)) return {};
  plane.origin /= length;
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
