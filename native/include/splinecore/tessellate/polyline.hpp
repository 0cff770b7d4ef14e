#pragma once

#include <optional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The points of one finite piece of a curve, x, y, z after x, y, z.
struct Polyline {
  std::vector<double> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
};

/// One polyline for each of pieces(), with `resolution` steps in what it holds of every span. A piece
/// that runs to infinity has four steps at least and ends at the last before it. A whole curve whose end
/// points are equal in every bit is closed.
/// @param reach   where given, a curve whose weights have not one sign ends where it leaves the box of its finite
///                control points by this length in a coordinate: also where it is finite, but far
/// @param around  where given, the box of these points stands for it, for any curve
/// @throws InvalidShape if the resolution is outside [1, 4096], there would be more than 2^22 samples, or the
///         reach is not positive.
std::vector<Polyline> polylines(const NurbsCurve& curve, int resolution, std::optional<double> reach = {},
                                std::span<const glm::dvec3> around = {});

}  // namespace splinecore
