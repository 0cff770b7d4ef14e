#pragma once

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The largest distance between the points of two curves at equal parameters: an upper bound, at most
/// 1 % above the truth unless that is below rounding.
///
/// By the hull of the difference on ever smaller pieces. Where a weight is below a sixteenth of the largest of
/// its span, points run off to infinity and are left out.
/// @throws InvalidShape if the domains differ.
double largest_distance(const NurbsCurve& a, const NurbsCurve& b);

}  // namespace splinecore
