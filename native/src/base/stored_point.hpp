#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Whether x, y and z are finite.
template <class Real>
bool is_number(const Real* values) {
  return std::isfinite(values[0]) && std::isfinite(values[1]) && std::isfinite(values[2]);
}

template <class Real>
void store(const glm::dvec3& value, Real* out) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = static_cast<Real>(value[axis]);
}

}  // namespace splinecore
#pragma GCC visibility pop
