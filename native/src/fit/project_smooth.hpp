#pragma once

#include "splinecore/fit/project.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// As project(), of a function that is smooth between the knots, or nearly: integrals by nodes of whole spans. Where it is not, the
/// curve is a little farther from it than it might be, which the error tells.
Approximation<NurbsCurve> project_smooth(const CurveFunction& function, const KnotVector& knots, bool fixed_ends);

}  // namespace splinecore
#pragma GCC visibility pop
