#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where shapes are brought before they are measured: the middle of their box to the origin, and their
/// size, by a power of two, to about 1. So no digit is lost far away and no square leaves the numbers.
struct Placement {
  glm::dvec3 origin{0.0};
  int exponent = 0;
};

inline Placement placement_of(std::span<const glm::dvec4> points) {
  Placement placement;
  const double largest = largest_coordinate(points);
  if (largest > 0.0) placement.exponent = std::ilogb(largest);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  placement.origin = 0.5 * low + 0.5 * high;
  return placement;
}

/// The same, but along axes where the middle is no farther from 0 than `far` times what reaches from there the points stay. From
/// far = 2 on no digit of a point is lost: where points are moved they differ from the middle by less than half of it, and such
/// differences are exact (Sterbenz, 1974).
inline Placement exact_placement(std::span<const glm::dvec4> points, double far = 2.0) {
  Placement placement = placement_of(points);
  for (int axis = 0; axis < 3; ++axis) {
    double reach = 0.0;
    for (const glm::dvec4& p : points) {
      if (p.w != 0.0) reach = std::max(reach, std::abs(p[axis] - placement.origin[axis]));
    }
    if (std::abs(placement.origin[axis]) <= far * reach) placement.origin[axis] = 0.0;
  }
  return placement;
}

/// A curve or patch in its place.
template <class Shape>
Shape placed(const Shape& shape, const Placement& placement) {
  const auto scaled = [&](double x) { return std::ldexp(x, -placement.exponent); };
  std::vector<glm::dvec4> points(shape.points().begin(), shape.points().end());
  for (glm::dvec4& p : points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = scaled(p.w == 0.0 ? p[axis] : p[axis] - placement.origin[axis]);
  }
  return shape.with_points(std::move(points));
}

/// A measure of the shape as it was given. @param dimension  1 for lengths, 2 for areas, -1 for curvatures
inline double given_size(double value, int dimension, const Placement& placement) {
  return std::ldexp(value, dimension * placement.exponent);
}

/// The same; NaN stays. @throws InvalidShape if it is too large for a number.
inline double finite_size(double value, int dimension, const Placement& placement, const char* name) {
  const double size = given_size(value, dimension, placement);
  if (!std::isinf(size)) return size;
  throw InvalidShape(std::string("the ") + name + " is too large for a number");
}

}  // namespace splinecore
#pragma GCC visibility pop
