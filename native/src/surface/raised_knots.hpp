#pragma once

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A clamped knot vector of another degree with the inner knots of a clamped one, where splines are less smooth by so many
/// derivatives, at least continuous.
/// @throws InvalidShape if splines on the given knots jump
KnotVector raised_knots(const KnotVector& knots, int degree, int less_smooth);

}  // namespace splinecore
#pragma GCC visibility pop
