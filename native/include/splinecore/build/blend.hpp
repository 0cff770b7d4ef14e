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

/// The Bezier curve from an end of a curve to an end of another one that continues both there: with the point, the
/// direction, the curvature vector and its derivative by the length for continuity 0, 1, 2, 3; of degree 2 k + 1. Row S7,
/// S16.
/// @param strengths  speeds at both ends by the distance between them, above 0: how far it follows each curve
/// @throws InvalidShape if the continuity is not 0 to 3, a strength is not above 0, the ends are one, or a curve stands
///         still at its end; PointAtInfinity.
BezierCurve blend(const BlendEnd& from, const BlendEnd& to, int continuity,
                  const std::array<double, 2>& strengths = {1.0, 1.0});

}  // namespace splinecore
