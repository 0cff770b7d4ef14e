#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "numbers_along.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A ball that touches two patches.
struct Contact {
  glm::dvec2 on_first;   ///< parameters
  glm::dvec2 on_second;
  glm::dvec3 first;      ///< points
  glm::dvec3 second;
  glm::dvec3 centre;
  double radius;
};

/// A ball beside the edge of two patches, which is v_start of both, u running along it over [0, 1].
class RollingBall {
 public:
  /// @param radii  by u of the first patch
  /// @throws InvalidShape if the tangent planes agree in the middle of the edge
  RollingBall(const NurbsPatch& first, const NurbsPatch& second, const NumbersAlong& radii);

  /// Where it touches the first, or the second patch at a parameter along the edge.
  /// @throws InvalidShape if it does not
  Contact at(double u, bool is_of_first) const;

 private:
  Contact start(double u) const;

  NurbsPatch first_;
  NurbsPatch second_;
  const NumbersAlong& radii_;
  double side_of_first_ = 0.0;   ///< of its normals
  double side_of_second_ = 0.0;
};

}  // namespace splinecore
#pragma GCC visibility pop
