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

/// Unit normals of one patch: what is the same for all its points.
class NormalFinder {
 public:
  explicit NormalFinder(const NurbsPatch& patch);

  /// The patch whose normals are taken: as it is, or where it is far from the origin, huge or tiny, brought near.
  const NurbsPatch& seen() const noexcept { return near_ ? *near_ : patch_; }
  bool is_moved() const noexcept { return near_.has_value(); }

  const NormalRounding& rounding() const noexcept { return rounding_; }

  /// The sides of seen() that are points.
  std::span<const Pole> poles() const noexcept { return poles_; }

  /// The limit of the normal when (u, v) is approached from inside the domain; NaN where there is none.
  glm::dvec3 limit(double u, double v, PatchOptions options) const;

 private:
  std::optional<glm::dvec3> at_pole(double u, double v, PatchOptions options) const;
  std::optional<glm::dvec3> first_term(double u, double v, PatchOptions options, int terms) const;

  const NurbsPatch& patch_;
  std::optional<NurbsPatch> near_;
  NormalRounding rounding_{};
  std::vector<Pole> poles_;
  double unit_ = 0.0;  ///< what rounding of the points themselves may amount to
};

}  // namespace splinecore
#pragma GCC visibility pop
