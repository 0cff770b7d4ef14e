#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "box_tree.hpp"
#include "kernels/kernels.hpp"
#include "near_space.hpp"
#include "splinecore/meet/rays.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The line of a ray in the space of a shape.
struct NearRay {
  glm::dvec3 foot;                    ///< its point that is nearest to the middle of the space
  glm::dvec3 way;                     ///< of length 1
  std::array<glm::dvec3, 2> across;   ///< at right angles to it and to each other, of length 1
  double before;                      ///< how far the origin lies behind the foot
  double step;                        ///< a length there, as a part of the direction
  double noise;                       ///< how much of a coordinate may be rounding

  /// @throws InvalidShape if the ray is not finite, has no direction or begins too far away.
  NearRay(const Ray& ray, const NearSpace& space, std::size_t index);

  double at(const glm::dvec3& point) const noexcept { return glm::dot(point - foot, way); }
  double along(double near) const noexcept { return (before + near) * step; }
  double near(double along) const noexcept { return along / step - before; }
  /// By how much a place along it may be off where a patch is met at a right angle.
  double slack() const noexcept { return kSlack * noise * step; }

  static constexpr double kSlack = 16.0;
};

/// A box that a line may meet: what it has of the line lies between two places of it.
struct BoxOnRay {
  double near;
  double far;
  std::size_t index;
};

/// The boxes of a group that a line may meet, numbered from `first` on, added to `met`.
void add_boxes_on(const NearRay& ray, const BoxGroup& group, std::size_t first, std::size_t count,
                  std::vector<BoxOnRay>& met);
void add_boxes_on(const NearRay& ray, const TurnedBoxGroup& group, std::size_t first, std::size_t count,
                  std::vector<BoxOnRay>& met);

/// Those of the leaves of a tree. @param waiting  memory that is used again
void add_leaves_on(const NearRay& ray, const BoxTree& tree, std::vector<std::vector<BoxOnRay>>& waiting,
                   std::vector<BoxOnRay>& met);

}  // namespace splinecore
#pragma GCC visibility pop
