#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The curve of remove_knot(), whose error is not measured.
NurbsCurve without_knot(const NurbsCurve& curve, double u, int times);

/// The curve with as few copies of a knot as leave the distance from `original`, which is the error, within the
/// tolerance, and a valid curve at all.
/// @param best  the curve with its error
Approximation<NurbsCurve> without_copies(Approximation<NurbsCurve> best, double u, const NurbsCurve& original,
                                         double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
