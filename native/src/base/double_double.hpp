#pragma once

#include <cmath>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A number as the unevaluated sum of two doubles: about 32 decimal digits.
///
/// For sums that cancel, so that the only digits lost are those of the last rounding. What overflows
/// becomes infinite or NaN, as it does in a double (Dekker 1971; Hida, Li and Bailey 2001).
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}
  constexpr DoubleDouble(double leading, double rest) : high(leading), low(rest) {}

  /// The nearest double.
  constexpr double rounded() const noexcept { return high + low; }
};

/// a + b without error, whatever their sizes (Knuth, TAOCP 4.2.2, theorem B).
inline DoubleDouble exact_sum(double a, double b) noexcept {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a * b without error, unless it underflows.
inline DoubleDouble exact_product(double a, double b) noexcept {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble sum = exact_sum(a.high, b.high);
  const DoubleDouble rest = exact_sum(a.low, b.low);
  const DoubleDouble joined = exact_sum(sum.high, sum.low + rest.high);
  return exact_sum(joined.high, joined.low + rest.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + -b; }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  const double third = (rest - b * second).high / b.high;
  return exact_sum(first, second) + third;
}

}  // namespace splinecore
#pragma GCC visibility pop
