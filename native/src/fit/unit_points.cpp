#include "unit_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace splinecore {

namespace {

glm::dvec3 scaled(const glm::dvec3& point, int exponent) {
  return {std::ldexp(point.x, exponent), std::ldexp(point.y, exponent), std::ldexp(point.z, exponent)};
}

}  // namespace

glm::dvec3 UnitPoints::back(const glm::dvec3& point) const { return middle + scaled(point, exponent); }

UnitPoints unit_points(std::span<const glm::dvec3> points) {
  glm::dvec3 low = points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const glm::dvec3 middle = 0.5 * low + 0.5 * high;
  const glm::dvec3 half = 0.5 * high - 0.5 * low;
  const double largest = std::max({half.x, half.y, half.z});
  const int exponent = largest > 0.0 ? std::ilogb(largest) + 1 : 0;
  UnitPoints made{{}, middle, exponent};
  made.points.reserve(points.size());
  for (const glm::dvec3& point : points) made.points.push_back(scaled(point - middle, -exponent));
  return made;
}

}  // namespace splinecore
