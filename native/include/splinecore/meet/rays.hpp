#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// From an origin along a direction of any length but 0.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

/// A place where a ray meets a patch, or where it begins to lie on it.
struct RayHit {
  double along;      ///< origin + along * direction
  double until;      ///< where it ceases to lie on the patch; `along` where it only meets it
  std::size_t patch; ///< of a set
  double u;
  double v;
  glm::dvec3 point;  ///< of the patch
  bool touches;      ///< whether the ray does not go through there
};

struct RayOptions {
  /// What of the lines counts, in multiples of the directions: from minus infinity on whole lines do. Places that are out by no
  /// more than rounding is in.
  Interval limits{0.0, std::numeric_limits<double>::infinity()};
  int threads = 0;  ///< 0: as many as are worth it
};

/// Of each ray the first place where it meets the patch, borders, seams and poles included; none where it misses it.
///
/// The boxes of Bernstein pieces leave few parts of them. On each the offsets from the ray along two directions across it
/// are polynomials in Bernstein's form, and their common zeros are found by halving (plane_zeros), as by Kajiya (1982)
/// and Nishita, Sederberg and Kakimoto (1990): a part is left out where hulls prove that it has none, and Newton's method
/// is used where they prove that it has one at most. So none is lost, and places are right to a few roundings of the
/// size. Where that does not tell them apart, as where a ray touches a patch, lies on it, goes through a pole, or weights
/// have both signs, intersections() of the line and the patch says what they are, within its own tolerance. A ray has the
/// same hit in any batch, on any number of threads.
/// @param out  as many as rays
/// @throws InvalidShape naming a ray that is not finite, has no direction or begins too far away, or of which
///         intersections() says so; if limits are not in order.
void first_hits(const NurbsPatch& patch, std::span<const Ray> rays, std::span<std::optional<RayHit>> out,
                const RayOptions& options = {});

/// The same of all patches of a set. Of those that are met at one place it is the first one.
void first_hits(const PatchSet& set, std::span<const Ray> rays, std::span<std::optional<RayHit>> out,
                const RayOptions& options = {});

/// Of each ray all places, in the order along it. Where a patch crosses itself there is one for each of its sheets, and
/// on an edge of several patches of a set one for each of these.
std::vector<std::vector<RayHit>> all_hits(const NurbsPatch& patch, std::span<const Ray> rays,
                                          const RayOptions& options = {});
std::vector<std::vector<RayHit>> all_hits(const PatchSet& set, std::span<const Ray> rays, const RayOptions& options = {});

}  // namespace splinecore
