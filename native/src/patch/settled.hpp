#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Real>
bool is_number(const Real* values) {
  return std::isfinite(values[0]) && std::isfinite(values[1]) && std::isfinite(values[2]);
}

template <class Real>
void store(const glm::dvec3& value, Real* out) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = static_cast<Real>(value[axis]);
}

/// The point of a homogeneous one at u and v by a division, where the kernels found no number.
/// @throws PointAtInfinity
glm::dvec3 settled_point(const NurbsPatch& patch, const glm::dvec4& h, double u, double v, AtInfinity at_infinity);

}  // namespace splinecore
#pragma GCC visibility pop
