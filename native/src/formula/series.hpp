#pragma once

#include <array>

#include "program.hpp"
#include "splinecore/base/order.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// c_0 + c_1 s + … + c_order s^order, cut off. NaN where a coefficient does not exist.
struct Series {
  int order = 0;
  std::array<double, kMaxOrder + 1> coefficients{};

  double& operator[](int k) noexcept { return coefficients[k]; }
  double operator[](int k) const noexcept { return coefficients[k]; }
};

/// The series of the result of a step from those of its operands. The first coefficient is what the
/// step makes of the first coefficients; where that is NaN, all are.
///
/// Recurrences for the coefficients: Griewank and Walther, Evaluating Derivatives, table 13.2.
Series apply(const Step& step, const Series& a) noexcept;
Series apply(Operation operation, const Series& a, const Series& b) noexcept;

}  // namespace splinecore
#pragma GCC visibility pop
