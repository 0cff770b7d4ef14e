#pragma once

#include <span>

namespace splinecore {

/// Degrees above this are refused: C(255, 127) and its neighbors are far from overflow.
inline constexpr int kMaxDegree = 255;

/// C(n, k) for 0 <= k <= n <= 3 kMaxDegree; exact while it fits 53 bits.
/// @throws std::out_of_range for others.
double binomial(int n, int k);

/// The degree + 1 Bernstein polynomials at t, in out; s is 1 - t.
///
/// Both t and s are taken so that the caller can give each to full accuracy.
/// Every value is a product of nonnegative factors, so each has a relative error of a few
/// times degree ulp, at any degree (lecture row S6).
void bernstein(int degree, double t, double s, std::span<double> out);

}  // namespace splinecore
