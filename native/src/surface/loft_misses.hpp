#pragma once

#include <span>

#include "fit/row_spline.hpp"
#include "loft_sections.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How far a spline that is to run through sections at parameters misses one of them, in their space: 0 where that is
/// rounding of their size. Between sections that are far off of even, splines of high degrees run so far away that rounding is more.
double largest_miss(const LoftSections& sections, const RowSpline& spline, std::span<const double> parameters);

/// How far from them, in their space, its control points lie.
double farthest_control(const RowSpline& spline);

}  // namespace splinecore
#pragma GCC visibility pop
