#pragma once

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws PointAtInfinity with parameters near which the weight of the patch is zero.
void require_finite_points(const NurbsPatch& patch);

/// @throws PointAtInfinity with a parameter of the range where the weight of the curve is zero.
void require_finite_points(const NurbsCurve& curve, const Interval& range);

}  // namespace splinecore
#pragma GCC visibility pop
