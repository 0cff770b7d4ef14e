#pragma once

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A clamped curve whose last span ends at another parameter: the same polynomials (blossoms, row S15).
NurbsCurve with_end(const NurbsCurve& curve, double end);

}  // namespace splinecore
#pragma GCC visibility pop
