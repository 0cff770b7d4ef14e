#pragma once

#include <optional>
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
/// @param reach  where given, a piece that runs to infinity ends where it leaves the box of the finite
///               control points by this length in a coordinate
/// @throws InvalidShape if the resolution is outside [1, 4096], there would be more than 2^22 samples, or the
///         reach is not positive.
std::vector<Polyline> polylines(const NurbsCurve& curve, int resolution, std::optional<double> reach = {});

}  // namespace splinecore
