#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The largest distance between the points of two patches at equal parameters: an upper bound, at most
/// 2 % above the truth unless that is below rounding.
///
/// By the hull of the difference on ever smaller pieces. Infinite where one patch runs to infinity and the other
/// stays in sight. Where the weights of both may be zero, points are left out of which each weight is below a
/// sixteenth of the largest on its piece: there both run off, and rounding decides how far apart. A search that
/// would take longer than a second ends before, with a bound that may be wide.
/// @throws InvalidShape if the domains differ.
double largest_distance(const NurbsPatch& a, const NurbsPatch& b);

}  // namespace splinecore
