#pragma once

#include <cmath>
#include <string>

#include "base/length.hpp"
#include "nearest_search.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/meet/nearest.hpp"
#include "within_period.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How far a point is from the place that was found of it. @param i  its number, for errors
inline double distance_to(const NearestPlace& place, const NearPoint& near, const glm::dvec3& point, std::size_t i,
                          const NearSpace& space) {
  const double distance =
      near.moved ? distance_of(point, space.leave(place.point)) : space.length(std::sqrt(place.squared));
  if (std::isfinite(distance)) return distance;
  throw InvalidShape("points" + index_text(i) + " is too far away: its distance is too large for a number");
}

/// The place on the shape itself.
inline NearestOnCurve on_shape(const NurbsCurve& curve, const NearSpace& space, const NearestPlace& place, double distance) {
  return {within_period(place.parameters[0], curve.knot_vector()), space.leave(place.point), distance};
}

inline NearestOnPatch on_shape(const NurbsPatch& patch, const NearSpace& space, const NearestPlace& place, double distance) {
  return {within_period(place.parameters[0], patch.knot_vector(Axis::u)),
          within_period(place.parameters[1], patch.knot_vector(Axis::v)), space.leave(place.point), distance};
}

}  // namespace splinecore
#pragma GCC visibility pop
