#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

struct HelixOptions {
  std::array<double, 2> radii{1.0, 1.0};  ///< at the start and the end of the axis, between them by its length
  double turns = 1.0;                     ///< negative: left-handed
  double phase = 0.0;                     ///< the angle of its start, in radians
  std::optional<glm::dvec3> start;        ///< the direction of the angle 0 at the start; none: as of CarriedFrame
  std::optional<double> tolerance;        ///< how far the result may be from the helix; none: 2^-20 of its size
};

/// A helix about a curve, or where its radii differ a spiral: a point that turns evenly by the length of the curve in
/// frames that turn no more than they must; where that has a corner it has a gap. By cubics with its tangents. S18.
/// @throws InvalidShape if a radius is below 0, both are 0, the turns are 0 or a number is not finite;
///         and as rotation_minimizing_frames() and lengths_at_parameters().
NurbsCurve helix(const NurbsCurve& axis, const HelixOptions& options);

}  // namespace splinecore
