#pragma once

#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/formula/polynomial.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The degree less one, where the polynomial allows it: divided by (1 - s) + s in the direction of u.
ScaledBernstein lowered_u(const ScaledBernstein& a);

/// The degree and one more in the direction of u.
ScaledBernstein raised_u(const ScaledBernstein& a);

/// u and v exchanged.
ScaledBernstein swapped(const ScaledBernstein& a);

/// The same polynomial with these degrees.
ScaledBernstein with_degrees(ScaledBernstein a, int degree_u, int degree_v);

/// Divided by the binomials: what the control points have as this coordinate.
std::vector<double> bezier_ordinates(const ScaledBernstein& a);

}  // namespace splinecore
#pragma GCC visibility pop
