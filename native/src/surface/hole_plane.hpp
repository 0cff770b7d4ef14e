#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "hole_side.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Places of a side, its ends among them, that are looked at to see how the hole lies.
std::vector<HolePlace> places_along(const HoleSide& side, int count = 17);

/// How long a piece of a side each of these places stands for.
std::vector<double> lengths_at(const std::vector<HolePlace>& places);

/// A plane that a hole lies over.
struct HolePlane {
  glm::dvec3 origin;
  glm::dvec3 x;
  glm::dvec3 y;
  glm::dvec3 normal;
  double size;  ///< how far points are from the origin

  glm::dvec3 at(const glm::dvec3& p) const { return along(p - origin); }
  glm::dvec3 along(const glm::dvec3& v) const { return glm::dvec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, normal)) / size; }
};

/// By the area that the sides go round, seen at places_along() each, about the middle of their lengths; none where the area is
/// next to nothing.
std::optional<HolePlane> plane_of(const std::vector<std::vector<HolePlace>>& sides);

}  // namespace splinecore
#pragma GCC visibility pop
