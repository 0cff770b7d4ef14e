#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Squares of distances between these keep all their digits.
inline constexpr double kLeastSquare = 1e-280;
inline constexpr double kMostSquare = 1e300;

/// Of two points; squares that leave the range of numbers are not taken.
inline double distance_of(const glm::dvec3& from, const glm::dvec3& to) noexcept {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double z = to.z - from.z;
  const double square = x * x + y * y + z * z;
  return square > kLeastSquare && square < kMostSquare ? std::sqrt(square) : std::hypot(x, y, z);
}

}  // namespace splinecore
#pragma GCC visibility pop
