#pragma once

#include <glm/vec3.hpp>

#include "splinecore/patch/evaluate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Unit normals of one patch: what is the same for all its points.
class NormalFinder {
 public:
  explicit NormalFinder(const NurbsPatch& patch);

  /// The normal at (u, v), where the first derivatives are S_u and S_v.
  glm::dvec3 at(double u, double v, const glm::dvec3& su, const glm::dvec3& sv, PatchOptions options) const;

 private:
  glm::dvec3 limit(double u, double v, PatchOptions options) const;

  const NurbsPatch& patch_;
  /// Size below which S_u x S_v of this patch is rounding.
  double negligible_;
};

}  // namespace splinecore
#pragma GCC visibility pop
