#pragma once

#include "series.hpp"

// What the rules of all functions are made of. Series that are put together have one order.
#pragma GCC visibility push(hidden)
namespace splinecore {

Series constant(int order, double value) noexcept;

/// Coefficients below `first` as they are, none from there on.
Series missing_from(Series a, int first) noexcept;

/// The first coefficient that is not zero; order + 1 if all are.
int leading(const Series& a) noexcept;

Series scaled(Series a, double factor) noexcept;
Series sum(Series a, const Series& b) noexcept;
Series difference(Series a, const Series& b) noexcept;
Series product(const Series& a, const Series& b) noexcept;
Series quotient(const Series& a, const Series& b) noexcept;

/// The last coefficient, which is not known, is 0.
Series derivative(const Series& a) noexcept;

/// r with r' = a / b.
Series integral_of_quotient(double start, const Series& a, const Series& b) noexcept;

/// The k-th coefficient of r where r' = a' b, for coefficients of b below k.
double integral_of_product(const Series& a, const Series& b, int k) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
