#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of two points; squares that leave the range of numbers are not taken.
inline double distance_of(const glm::dvec3& from, const glm::dvec3& to) noexcept {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double z = to.z - from.z;
  const double square = x * x + y * y + z * z;
  constexpr double kSmall = 1e-280;
  constexpr double kLarge = 1e300;
  return square > kSmall && square < kLarge ? std::sqrt(square) : std::hypot(x, y, z);
}

}  // namespace splinecore
#pragma GCC visibility pop
