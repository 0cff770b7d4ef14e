#pragma once

#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parts of a range of the domain, in order and within one span each, inside which the first derivative is
/// nowhere zero: cut at cusps, or so near them that the rest is no longer than rounding.
///
/// Between a cusp and the nearest node of a rule the rule sees nothing of it. Here Bernstein coefficients of
/// the derivative decide: on one side of a plane they leave no room for a zero.
std::vector<Interval> regular_parts(const NurbsCurve& curve, const Interval& range);

}  // namespace splinecore
#pragma GCC visibility pop
