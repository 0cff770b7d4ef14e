#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/build/fillet.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parameters of two curves at which a circle touches both.
struct TouchedBoth {
  double a;
  double b;
  std::optional<Fillet> fillet;  ///< none where the curves touch each other
};

/// Two curves, and on which side of each the center of a circle is that touches both.
class BesideBoth {
 public:
  BesideBoth(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal, const std::array<double, 2>& sides)
      : a_(a), b_(b), normal_(normal), sides_(sides) {}

  /// Newton's method for where the points beside both curves are one. Where both run the same way, b's is moved along alone.
  std::optional<TouchedBoth> near(double u, double v) const;

  /// If the points beside these places are one.
  std::optional<TouchedBoth> at(double u, double v) const;

 private:
  const NurbsCurve& a_;
  const NurbsCurve& b_;
  glm::dvec3 normal_;
  std::array<double, 2> sides_;
};

}  // namespace splinecore
#pragma GCC visibility pop
