#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/formula/formula.hpp"

namespace splinecore {

/// Coefficients c_0, c_1, … of the powers of the one variable; nothing where the formula is not made of
/// sums, products, quotients by constants and powers with whole exponents, or goes over the highest degree.
///
/// The last coefficient is not zero, but for the polynomial 0.
/// @throws InvalidShape if the formula has more than one variable.
std::optional<std::vector<double>> polynomial(const Formula& formula, int highest_degree);

/// (degree_u + 1) x (degree_v + 1) coefficients, row after row; degree_v = 0 where there is one variable.
struct ScaledBernstein {
  int degree_u = 0;
  int degree_v = 0;
  std::vector<double> coefficients;
};

/// Bernstein coefficients over the domain of each variable, not yet divided by the binomials.
///
/// Coefficient i belongs to (1 - s)^(n - i) s^i, s from 0 to 1 over the domain. Found without a detour
/// through powers, so that no digits are lost however far from 0 the domain lies (Farouki and Rajan 1988).
/// The degree is that of the expression as it is written: t^2 - t^2 has degree 2.
/// @throws InvalidShape unless the formula has one or two variables, each with a domain.
std::optional<ScaledBernstein> scaled_bernstein(const Formula& formula, std::span<const Interval> domains,
                                                int highest_degree);

}  // namespace splinecore
