#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// @throws InvalidShape naming the argument and the coordinate if one is not finite.
inline void require_vector(const glm::dvec3& v, const std::string& argument) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(v[axis])) continue;
    throw InvalidShape(argument + "." + "xyz"[axis] + " = " + text_of(v[axis]) + " is not finite");
  }
}

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

/// Multiplies coefficients so that the largest quadratic one, or where all of these are zero the first that is
/// not, becomes 1. @throws InvalidShape if all are zero: rounding has left nothing of the equation.
inline void normalize(std::array<double, 6>& k) {
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double largest = *std::max_element(k.begin(), k.begin() + 3, by_size);
  const auto first = std::find_if(k.begin(), k.end(), [](double value) { return value != 0.0; });
  if (first == k.end()) throw InvalidShape("the points give no equation: it is lost in rounding");
  const double divisor = largest != 0.0 ? largest : *first;
  for (double& value : k) value = value == 0.0 ? 0.0 : value / divisor;
}

}  // namespace splinecore
#pragma GCC visibility pop
