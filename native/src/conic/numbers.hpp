#pragma once

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

}  // namespace splinecore
