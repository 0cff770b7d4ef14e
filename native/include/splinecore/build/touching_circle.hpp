#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// A circle that touches three curves.
struct TouchingCircle {
  NurbsCurve arc;  ///< from where it touches the first one through the second one to the third one
  glm::dvec3 center;
  double radius;
  std::array<double, 3> parameters;
};

/// The circle that touches three curves of one plane near given places of theirs, by Newton's method from the circle
/// through these. Of Apollonius' eight the one with the center on that side of each curve. S18.
/// @param near  a parameter of each
/// @throws InvalidShape if a parameter is outside its domain, the normal is zero, the places are on one line, or there
///         is none near them.
TouchingCircle touching_circle(const std::array<NurbsCurve, 3>& curves, const std::array<double, 3>& near,
                               const glm::dvec3& normal);

}  // namespace splinecore
