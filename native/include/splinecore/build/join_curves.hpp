#pragma once

#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Curves joined where their ends are within a tolerance of each other, the nearest first: ends meet in their middle.
///
/// In the order of the first curve of each, which keeps its direction; the others are turned as they come. A chain that
/// comes back closes. Closed curves, and those that no end is near, stay as they are.
/// @throws InvalidShape if there is no curve, or the tolerance is below 0 or no number; and as joined().
std::vector<NurbsCurve> join_curves(std::span<const NurbsCurve> curves, double tolerance);

}  // namespace splinecore
