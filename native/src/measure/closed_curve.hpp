#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "near_curve.hpp"
#include "signs.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A closed curve seen against a direction, near the origin.
struct ClosedCurve {
  NearCurve near;
  View view;
  glm::dvec2 start;
  glm::dvec2 end;
};

/// @throws InvalidShape if the normal is zero, the curve in several pieces, or its ends farther apart than 1e-9 of its size
ClosedCurve closed_curve(const NurbsCurve& curve, const glm::dvec3& normal, const Placement& placement);

}  // namespace splinecore
#pragma GCC visibility pop
