#pragma once

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/surface/sweep.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A rail that closes smoothly as a periodic one, one with corners from one of them on.
/// @param negligible  angles of corners that are none
NurbsCurve prepared_rail(const NurbsCurve& rail, double negligible);

/// @throws InvalidShape if frames are upright by no direction
void require_upright(const SweepOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
