#pragma once

#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A Bezier curve in parts that stand still at their ends alone, as at a cusp, where its direction turns round.
std::vector<BezierCurve> cut_where_still(const BezierCurve& curve);

}  // namespace splinecore
#pragma GCC visibility pop
