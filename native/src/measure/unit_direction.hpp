#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "splinecore/base/errors.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws InvalidShape naming it if it is zero or not finite.
inline glm::dvec3 unit_direction(const glm::dvec3& v, const char* name) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const bool is_number = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  if (!is_number || !(size > 0.0)) throw InvalidShape(std::string(name) + " is not a direction: it is zero or not finite");
  // A tiny one at once would leave the numbers.
  const int exponent = std::ilogb(size);
  return glm::normalize(glm::dvec3(std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent),
                                   std::scalbn(v.z, -exponent)));
}

}  // namespace splinecore
#pragma GCC visibility pop
