#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "hole.hpp"
#include "hole_plane.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// In a neighbor's plane: seen along the axis straight on to the apex, or as near to that as may be.
enum class LeavingWay { straight_on, nearest };

/// Where the surface in a round hole is highest over it, more or less: lines from all sides run together there.
struct Apex {
  glm::dvec3 point;
  glm::dvec3 normal;   ///< of the plane that the hole lies over
  glm::dvec3 axis;     ///< along which it is seen, as long as it rises by 1 over that plane
  glm::dvec3 rise;     ///< in that plane: the slope of the tangent plane over it
  double speed = 1.0;  ///< of lines that arrive, by their distance seen along the axis
  LeavingWay leaving = LeavingWay::straight_on;

  /// The derivative at the apex, by t from 0 to 1, of the line from a point of a side; a linear function of it.
  glm::dvec3 arriving(const glm::dvec3& from) const { return flattened(point - from); }

  /// How that changes where the point does.
  glm::dvec3 arriving_changes(const glm::dvec3& change) const { return flattened(-change); }

  /// A way as seen along the axis.
  glm::dvec3 seen(const glm::dvec3& way) const { return way - axis * glm::dot(normal, way); }

  /// The same, in the tangent plane, times the speed.
  glm::dvec3 flattened(const glm::dvec3& way) const {
    const glm::dvec3 flat = seen(way);
    return speed * (flat + normal * glm::dot(rise, flat));
  }
};

/// How fast a line leaves a place, by t from 0 to 1, to go on to the apex in the neighbor's plane: as a circle does that
/// turns as far, or an ellipse that it is seen as. Straight on without a neighbor.
glm::dvec3 leaving(const HolePlace& place, const Apex& apex);

/// The apex that neighbors let expect: lines from all round, that leave in their planes at right angles to the sides, come
/// to it along circles, as nearly as one point and one tangent plane allow.
/// @throws InvalidShape where the hole lies over no plane, or is not seen whole from its middle
Apex apex_of(const Hole& hole, LeavingWay leaving);

/// The same of sides over a plane, seen at places_along() each; none where these are not seen whole from its origin.
std::optional<Apex> apex_over(const HolePlane& plane, const std::vector<std::vector<HolePlace>>& sides,
                              LeavingWay leaving = LeavingWay::straight_on);

}  // namespace splinecore
#pragma GCC visibility pop
