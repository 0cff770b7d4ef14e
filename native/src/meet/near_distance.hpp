#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>

#include "near_space.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point that distances are measured from, and the near space that they are measured in.
class NearOrigin {
 public:
  /// @throws InvalidShape with the name if the point is not finite.
  NearOrigin(const glm::dvec3& point, const NearSpace& space, std::string name);

  const NearPoint& near() const noexcept { return near_; }

  /// Where a point of the near space lies.
  glm::dvec3 leave(const glm::dvec3& near) const noexcept { return space_.leave(near); }

  /// How far it is from the given point. @throws InvalidShape if that is too large for a number.
  double distance_to(const glm::dvec3& near) const;

 private:
  glm::dvec3 point_;
  NearSpace space_;
  NearPoint near_;
  std::string name_;
};

/// How far places that are as near as the nearest one may be.
/// @param tolerance  none: a few roundings of the coordinates
double limit_of(double least, std::optional<double> tolerance, std::span<const glm::dvec4> points) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
