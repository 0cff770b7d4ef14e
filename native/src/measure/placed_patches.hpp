#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "base/placement.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Patches in their place.
inline std::vector<NurbsPatch> placed_patches(std::span<const NurbsPatch* const> patches, const Placement& placement) {
  std::vector<NurbsPatch> out;
  for (const NurbsPatch* patch : patches) out.push_back(placed(*patch, placement));
  return out;
}

/// A point of the place where it was given.
inline glm::dvec3 given_point(const glm::dvec3& p, const Placement& placement) {
  glm::dvec3 given = placement.origin;
  for (int i = 0; i < 3; ++i) given[i] += std::ldexp(p[i], placement.exponent);
  return given;
}

/// Half the diagonal of the box of the points, in their place.
inline double radius_of(std::span<const glm::dvec4> points, const Placement& placement) {
  glm::dvec3 far(0.0);
  for (const glm::dvec4& p : points) {
    if (p.w == 0.0) continue;
    for (int i = 0; i < 3; ++i) {
      far[i] = std::max(far[i], std::abs(std::ldexp(p[i] - placement.origin[i], -placement.exponent)));
    }
  }
  return glm::length(far);
}

}  // namespace splinecore
#pragma GCC visibility pop
