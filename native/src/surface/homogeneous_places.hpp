#pragma once

#include <cmath>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/evaluate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Homogeneous points of a curve, with its own weights.
inline std::vector<glm::dvec4> homogeneous_places(const NurbsCurve& curve, std::span<const double> at) {
  std::vector<glm::dvec4> found(at.size());
  evaluate_homogeneous(curve, at, found);
  const double factor = std::ldexp(1.0, curve.weight_exponent());
  for (glm::dvec4& p : found) p *= factor;
  return found;
}

}  // namespace splinecore
#pragma GCC visibility pop
