#pragma once

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/fit/rebuild.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// rebuild() on these knots, periodic where the curve is, over its domain.
Approximation<NurbsCurve> rebuilt_on(const NurbsCurve& curve, const KnotVector& knots, KeptEnds ends);

}  // namespace splinecore
#pragma GCC visibility pop
