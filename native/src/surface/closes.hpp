#pragma once

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether a curve ends where it begins and with the same weight, up to rounding: whether made_periodic() takes it.
bool closes(const NurbsCurve& curve);

}  // namespace splinecore
#pragma GCC visibility pop
