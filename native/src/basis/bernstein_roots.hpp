#pragma once

#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a polynomial over [0, 1] is zero, in order: each root once, as an interval without length, known to its last
/// digits; [0, 1] if it is zero everywhere. Roots that noise does not tell apart are one, in the middle of them.
///
/// Halving by de Casteljau until Bernstein coefficients change their sign once, which is one root by Descartes's rule
/// of signs, then bisection (Lane and Riesenfeld 1981; S6).
/// @param coefficients  Bernstein's, degree + 1 of them
/// @param noise         how much of a coefficient may be rounding
std::vector<Interval> bernstein_zeros(std::span<const double> coefficients, double noise);

/// The value at t of [0, 1], by de Casteljau.
double bernstein_value(std::span<const double> coefficients, double t);

}  // namespace splinecore
#pragma GCC visibility pop
