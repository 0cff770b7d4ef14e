#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// How an offset closes the gap at a corner of the curve.
enum class OffsetCorner { round, sharp };

struct OffsetOptions {
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< of the plane that the curve is in
  std::optional<double> tolerance;   ///< how far the result may be from the offset; none: 2^-20 of the size
  OffsetCorner corner = OffsetCorner::round;
  bool trimmed = false;  ///< without parts nearer to the curve than the distance by more than the tolerance
};

/// The curve at a distance to the left of a plane curve, seen against the normal; to the right where it is negative.
///
/// Lines and arcs of circles are moved exactly; other spans become cubics with the tangents of the offset, halved until
/// they are within the tolerance (Tiller and Hanson 1984), with ends where it has cusps. At corners an arc, or the corner
/// of both tangents up to four times the distance away. Of what crosses itself, trimmed, the parts stay that are as far
/// from the curve as they should be, up to the tolerance: all of it that is as far belongs to them (S18). In several parts
/// where the curve has gaps or is trimmed.
/// @throws InvalidShape if the curve is not in a plane with that normal, up to the tolerance, if a number is not finite,
///         the distance or the normal is zero, or nothing is left.
std::vector<NurbsCurve> offset(const NurbsCurve& curve, double distance, const OffsetOptions& options = {});

}  // namespace splinecore
