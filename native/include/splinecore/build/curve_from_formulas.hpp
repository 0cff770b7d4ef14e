#pragma once

#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/formula/formula.hpp"

namespace splinecore {

/// The curve x(t), y(t) and, where there is a third formula, z(t) over the domain; its parameter is t
/// (lecture row S1).
///
/// Where all are polynomials, one Bezier span of their highest degree, exact: the error is 0. Otherwise
/// quintic pieces with the value and two derivatives of the formulas at their ends: C2. A piece is cut in
/// two till it lies within the tolerance at every place where it is measured, at 4096 places of the
/// domain or more; the error is the largest distance that was found. At a joint where a formula has no two
/// derivatives (the kink of abs(t), the start of sqrt(t)) the curve is C0.
/// @throws InvalidShape if there are not two or three formulas of one variable each, the domain is not
///         finite or has no length, the tolerance is not positive, or naming a parameter where a formula
///         is undefined; ToleranceNotReached at a jump or a pole, or with more than 100,000 pieces.
Approximation<NurbsCurve> curve_from_formulas(std::span<const Formula> coordinates, const Interval& domain,
                                              double tolerance);

}  // namespace splinecore
