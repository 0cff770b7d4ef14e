#pragma once

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The curve of reduced(), whose error is not measured.
NurbsCurve of_lower_degree(const NurbsCurve& curve, int times);

}  // namespace splinecore
#pragma GCC visibility pop
