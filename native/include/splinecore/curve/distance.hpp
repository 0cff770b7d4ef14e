#pragma once

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The largest distance between the points of two curves at equal parameters: an upper bound, at most
/// 1 % above the truth unless that is below rounding.
///
/// By the hull of the difference on ever smaller pieces. Infinite where one curve runs to infinity and the other
/// stays in sight. Where the weights of both may be zero, points are left out of which each weight is below a
/// sixteenth of the largest on its span: there both run off, and rounding decides how far apart.
/// @throws InvalidShape if the domains differ.
double largest_distance(const NurbsCurve& a, const NurbsCurve& b);

}  // namespace splinecore
