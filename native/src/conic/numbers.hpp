#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

namespace splinecore {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// a b - c d to the last digit or two, whatever cancels (Kahan; Jeannerod, Louvet and Muller 2013).
inline double difference_of_products(double a, double b, double c, double d) noexcept {
  const double cd = c * d;
  return std::fma(a, b, -cd) - std::fma(c, d, -cd);
}

/// The cross product with the same care.
inline glm::dvec3 accurate_cross(const glm::dvec3& a, const glm::dvec3& b) noexcept {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// Multiplies coefficients, not all zero: largest quadratic coefficient becomes 1 in size, the first that is not zero positive.
inline void normalise(std::array<double, 6>& k) {
  const double size = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])});
  const double first = *std::find_if(k.begin(), k.end(), [](double value) { return value != 0.0; });
  const double divisor = std::copysign(size > 0.0 ? size : 1.0, first);
  for (double& value : k) value = value == 0.0 ? 0.0 : value / divisor;
}

}  // namespace splinecore
