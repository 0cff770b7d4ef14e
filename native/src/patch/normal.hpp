#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "pole.hpp"
#include "splinecore/patch/evaluate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is the same for all normals of a patch.
struct NormalFacts {
  explicit NormalFacts(const NurbsPatch& patch);

  std::optional<NurbsPatch> near;  ///< the patch brought near, where it is far from the origin, huge or tiny
  NormalRounding rounding{};
  std::vector<Pole> poles;
  double unit = 0.0;  ///< what rounding of the points themselves may amount to
};

/// Unit normals of one patch.
class NormalFinder {
 public:
  explicit NormalFinder(const NurbsPatch& patch);

  /// The patch whose normals are taken: as it is, or where it is far from the origin, huge or tiny, brought near.
  const NurbsPatch& seen() const noexcept { return facts_.near ? *facts_.near : patch_; }
  bool is_moved() const noexcept { return facts_.near.has_value(); }

  const NormalRounding& rounding() const noexcept { return facts_.rounding; }

  /// The sides of seen() that are points.
  std::span<const Pole> poles() const noexcept { return facts_.poles; }

  /// The limit of the normal when (u, v) is approached from inside the domain; NaN where there is none.
  glm::dvec3 limit(double u, double v, PatchOptions options) const;

 private:
  std::optional<glm::dvec3> at_pole(double u, double v, PatchOptions options) const;
  std::optional<glm::dvec3> first_term(double u, double v, PatchOptions options, int terms) const;

  const NurbsPatch& patch_;
  const NormalFacts& facts_;
};

}  // namespace splinecore
#pragma GCC visibility pop
