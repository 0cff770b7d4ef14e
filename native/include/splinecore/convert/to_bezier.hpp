#pragma once

#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/patch/bezier_patch.hpp"

namespace splinecore {

/// One Bezier curve for each span of positive length, in order (blossoms; The NURBS Book, A5.6).
/// @throws InvalidShape if a span lies at infinity altogether.
std::vector<BezierCurve> to_bezier(const NurbsCurve& curve);

/// The Bezier patches of a NURBS patch, row after row of count_v.
struct BezierGrid {
  int count_u = 0;
  int count_v = 0;
  std::vector<BezierPatch> patches;
};

BezierGrid to_bezier(const NurbsPatch& patch);

}  // namespace splinecore
