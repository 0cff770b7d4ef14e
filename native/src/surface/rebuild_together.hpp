#pragma once

#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Several curves on one knot vector of this degree over the domain of the first, with few spans: even ones, or where these
/// would be many denser where curves bend sharply, and knots at corners and creases where that takes fewer: each the nearest one in the integral of the squared distance. Periodic if all are.
/// @returns the curves, polynomial, and the largest distance of one at equal parameters
/// @throws ToleranceNotReached if 4096 spans do not come within the tolerance; InvalidShape unless it is positive.
Approximation<std::vector<NurbsCurve>> rebuild_together(std::span<const NurbsCurve> curves, int degree, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
