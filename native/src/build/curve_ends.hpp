#pragma once

#include <glm/vec3.hpp>
#include <optional>
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

/// Parts of curves that are shorter, by the whole, are none.
inline constexpr double kNothing = 0x1p-36;

/// The parameter at a length from the start of a curve, its end where the length passes that by rounding.
/// @returns none beyond the ends
std::optional<double> parameter_along(const NurbsCurve& curve, double length);

/// A curve and another one that starts where it ends, as fast there as it is.
NurbsCurve follow(const NurbsCurve& curve, const NurbsCurve& more);

/// A clamped curve whose ends are one but for what they are apart, in their middle.
NurbsCurve with_one_end(const NurbsCurve& curve);

/// Several curves, each following the one before it.
NurbsCurve chained(std::span<const NurbsCurve> curves);

}  // namespace splinecore
#pragma GCC visibility pop
