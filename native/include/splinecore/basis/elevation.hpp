#pragma once

#include "splinecore/basis/point_matrix.hpp"

namespace splinecore {

/// The same functions as functions of one degree more: every distinct knot has one copy more.
///
/// Outer knots that nothing depends on any more are left out. Each new point is the mean of degree + 1
/// points of refined curves, so its weights are convex (Ramshaw 1989, ch. 7: the blossom of degree
/// p + 1 is the mean of that of degree p over all choices of its arguments; lecture row S15).
/// @throws InvalidShape if the degree would exceed kMaxDegree.
PointMatrix elevation(const KnotVector& knots);

}  // namespace splinecore
