#pragma once

#include <array>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// An end of a curve.
struct BlendEnd {
  const NurbsCurve& curve;
  bool is_end;  ///< where it ends, or where it begins
};

/// A Bezier curve that joins the ends of two curves with equal points, directions, curvature vectors and their derivatives by arc
/// length, for continuity 0 to 3 (G0 to G3). Its degree is 2 * continuity + 1. Rows S7, S16.
/// @param strengths  speeds at both ends as parts of the distance between them, above 0: larger ones follow each curve farther
/// @throws InvalidShape if the continuity is not 0 to 3, a strength is not above 0, the ends coincide, or the derivative of a curve
///         is 0 at its end; PointAtInfinity.
BezierCurve blend(const BlendEnd& from, const BlendEnd& to, int continuity,
                  const std::array<double, 2>& strengths = {1.0, 1.0});

}  // namespace splinecore
