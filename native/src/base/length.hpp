#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Squares of lengths between these keep all their digits.
inline constexpr double kLeastSquare = 1e-280;
inline constexpr double kMostSquare = 1e300;

/// Of a vector whose square may leave the range of numbers; the same bits wherever square roots are right, which
/// std::hypot of three does not promise.
inline double length_of(const glm::dvec3& v) noexcept {
  const double square = v.x * v.x + v.y * v.y + v.z * v.z;
  if (square > kLeastSquare && square < kMostSquare) return std::sqrt(square);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (std::isnan(square) || !(largest > 0.0) || largest > std::numeric_limits<double>::max()) return square;
  const int exponent = std::ilogb(largest);
  const double x = std::ldexp(v.x, -exponent);
  const double y = std::ldexp(v.y, -exponent);
  const double z = std::ldexp(v.z, -exponent);
  return std::ldexp(std::sqrt(x * x + y * y + z * z), exponent);
}

/// Of two points; their difference may leave the range of numbers.
inline double distance_of(const glm::dvec3& from, const glm::dvec3& to) noexcept {
  const double distance = length_of(to - from);
  return distance <= std::numeric_limits<double>::max() ? distance : 2.0 * length_of(0.5 * to - 0.5 * from);
}

inline double distance_to_segment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) noexcept {
  const glm::dvec3 way = to - from;
  const double length = length_of(way);
  if (length == 0.0) return length_of(point - from);
  const glm::dvec3 along = way / length;
  const glm::dvec3 offset = point - from;
  const double place = std::clamp(offset.x * along.x + offset.y * along.y + offset.z * along.z, 0.0, length);
  return length_of(offset - place * along);
}

}  // namespace splinecore
#pragma GCC visibility pop
