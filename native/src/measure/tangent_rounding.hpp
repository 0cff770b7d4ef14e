#pragma once

#include <glm/vec3.hpp>

#include "splinecore/patch/evaluate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The point and the first derivatives of a patch at a place.
struct PatchSlopes {
  glm::dvec3 point;
  glm::dvec3 u;
  glm::dvec3 v;
};

/// Whether the product of two derivatives is known to a ten-thousandth, by the control points that they depend on: of patches whose weights
/// or points differ much they are small beside the whole, and no rounding.
/// @param patch  near the origin
bool is_product_known(const NurbsPatch& patch, double u, double v, const PatchSlopes& tangents, PatchOptions options);

}  // namespace splinecore
#pragma GCC visibility pop
