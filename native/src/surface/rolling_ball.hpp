#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "numbers_along.hpp"
#include "rim_start.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A ball that touches two patches.
struct Contact {
  glm::dvec2 on_first;   ///< parameters
  glm::dvec2 on_second;
  glm::dvec3 first;      ///< points
  glm::dvec3 second;
  glm::dvec3 center;
  double radius;
  /// Of the circle in which it touches the surface that it leaves behind, through both contacts: a great circle unless its radius
  /// changes.
  glm::dvec3 circle_center;
  double circle_radius;
};

/// Where along the edge the way of a ball may be less smooth.
struct BallJoint {
  double at;         ///< a parameter of the first patch
  const char* what;  ///< is there
};

/// A ball beside the edge of two patches, which is v_start of both, u running along it over [0, 1].
class RollingBall {
 public:
  /// @param radii  by u of the first patch
  /// @param rims   where one is at a u of the other, if not at the same
  /// @throws InvalidShape if the tangent planes agree in the middle of the edge
  RollingBall(const NurbsPatch& first, const NurbsPatch& second, const NumbersAlong& radii,
              const std::optional<RimPlaces>& rims);

  /// Where it touches the first, or the second patch at a parameter along the edge.
  /// @throws InvalidShape if it does not
  Contact at(double u, bool is_of_first) const;

  /// Knots of both patches, and where radii are given, in order.
  std::vector<BallJoint> joints() const;

  /// By how much the radius changes with the parameter of the first patch.
  double growth(double u) const { return radii_.slope_beyond(u); }

  /// Of the first patch, shares of the way from one parameter along the edge to another: of rims that are run through at different
  /// paces by lengths, which have no kinks where parameters have.
  std::vector<double> between(double from, double to, std::span<const double> shares) const;

 private:
  /// Gives the contact with the first patch at a parameter its circle.
  void tilt(Contact& contact, double u) const;
  Contact start(double u, bool is_of_first) const;

  NurbsPatch first_;
  NurbsPatch second_;
  const NumbersAlong& radii_;
  const std::optional<RimPlaces>& rims_;
  double side_of_first_ = 0.0;   ///< of its normals
  double side_of_second_ = 0.0;
};

}  // namespace splinecore
#pragma GCC visibility pop
