#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a curve starts or ends, in which direction it goes there and how fast.
struct DirectedEnd {
  glm::dvec3 point;
  glm::dvec3 tangent;
  double speed;
};

/// @throws InvalidShape if it stands still there.
DirectedEnd start_of(const NurbsCurve& curve);
DirectedEnd end_of(const NurbsCurve& curve);

glm::dvec3 point_at(const NurbsCurve& curve, double u);
NurbsCurve line_between(const glm::dvec3& a, const glm::dvec3& b);

/// A curve and another one that starts where it ends, as fast there as it is.
NurbsCurve follow(const NurbsCurve& curve, const NurbsCurve& more);

/// A clamped curve whose ends are one but for what they are apart, in their middle.
NurbsCurve with_one_end(const NurbsCurve& curve);

/// Several curves, each following the one before it.
NurbsCurve chained(std::span<const NurbsCurve> curves);

}  // namespace splinecore
#pragma GCC visibility pop
