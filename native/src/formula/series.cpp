#include "series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "series_algebra.hpp"

namespace splinecore {

namespace {

Series exponential(const Series& a, double start) noexcept {
  Series r = constant(a.order, start);
  for (int k = 1; k <= a.order; ++k) r[k] = integral_of_product(a, r, k);
  return r;
}

/// r and its partner p with r' = a' p and p' = sign a' r: sines and cosines of both kinds.
struct Partners {
  Series r;
  Series p;
};

Partners sine_like(const Series& a, double r0, double p0, double sign) noexcept {
  Partners both{constant(a.order, r0), constant(a.order, p0)};
  for (int k = 1; k <= a.order; ++k) {
    both.r[k] = integral_of_product(a, both.p, k);
    both.p[k] = sign * integral_of_product(a, both.r, k);
  }
  return both;
}

/// r with r' = a' (1 + sign r^2): tangents of both kinds.
Series tangent_like(const Series& a, double start, double sign) noexcept {
  Series r = constant(a.order, start);
  Series slope = constant(a.order, 1.0 + sign * start * start);
  for (int k = 1; k <= a.order; ++k) {
    r[k] = integral_of_product(a, slope, k);
    for (int j = 0; j <= k; ++j) slope[k] += sign * r[j] * r[k - j];
  }
  return r;
}

/// a^exponent where a does not start at zero.
Series plain_power(const Series& a, double exponent, double start) noexcept {
  Series r = constant(a.order, start);
  for (int k = 1; k <= a.order; ++k) {
    double total = 0.0;
    for (int j = 1; j <= k; ++j) total += (exponent * j - (k - j)) * a[j] * r[k - j];
    r[k] = total / (k * a[0]);
  }
  return r;
}

/// a^exponent for a positive exponent that is no whole number; cbrt also of a negative a.
Series root(const Series& a, double exponent, double start) noexcept {
  if (a[0] != 0.0) return plain_power(a, exponent, start);
  // Of s^m a root is s^(m exponent): all derivatives below that order are zero.
  const double order = leading(a) * exponent;
  return missing_from(constant(a.order, 0.0), static_cast<int>(std::min(std::ceil(order), a.order + 1.0)));
}

/// By squaring: products alone, which stay exact where the recurrence divides by what is nearly zero.
Series whole_power(const Series& a, int exponent) noexcept {
  Series power = a;
  Series out = constant(a.order, 1.0);
  for (int rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) out = product(out, power);
    if (rest > 1) power = product(power, power);
  }
  return out;
}

Series constant_power(const Series& a, double exponent, double start) noexcept {
  constexpr double kMostSquared = 1024.0;
  const bool whole = std::trunc(exponent) == exponent;
  if (!whole) return exponent > 0.0 ? root(a, exponent, start) : plain_power(a, exponent, start);
  if (std::abs(exponent) > kMostSquared) {
    return a[0] == 0.0 ? constant(a.order, 0.0) : plain_power(a, exponent, start);
  }
  const Series power = whole_power(a, static_cast<int>(std::abs(exponent)));
  return exponent < 0.0 ? quotient(constant(a.order, 1.0), power) : power;
}

/// Changes its sign where its argument does: at a simple zero, and at any other of odd order, a kink.
Series absolute(const Series& a) noexcept {
  const int k = leading(a);
  if (k > a.order) return a;
  if (k % 2 == 1) return missing_from(constant(a.order, 0.0), k);
  return a[k] < 0.0 ? scaled(a, -1.0) : a;
}

/// Flat, but for a jump where a has the value `step`.
Series stepped(const Series& a, double value, double step) noexcept {
  return missing_from(constant(a.order, value), a[0] == step ? 1 : a.order + 1);
}

/// The one of a and b that is the smaller (sign = 1) or the larger (sign = -1) on both sides.
Series chosen(const Series& a, const Series& b, double sign) noexcept {
  const Series apart = difference(b, a);
  const int k = leading(apart);
  if (k > a.order) return a;
  if (k % 2 == 1) return missing_from(a, k);
  return sign * apart[k] > 0.0 ? a : b;
}

Series arc_tangent(const Series& y, const Series& x, double start) noexcept {
  // On the negative x axis the angle jumps where y changes its sign.
  const int k = leading(y);
  if (x[0] < 0.0 && k <= y.order && k % 2 == 1) return missing_from(constant(y.order, start), 1);
  const Series turning = difference(product(x, derivative(y)), product(y, derivative(x)));
  return integral_of_quotient(start, turning, sum(product(x, x), product(y, y)));
}

/// a^b for an exponent that varies: exp(b log a).
Series varying_power(const Series& a, const Series& b, double start) noexcept {
  if (!(a[0] > 0.0)) return missing_from(constant(a.order, start), 1);
  return exponential(product(b, integral_of_quotient(std::log(a[0]), derivative(a), a)), start);
}

/// (1 - a)(1 + a): as a product 1 - a^2 loses nothing near 1.
Series one_less_square(const Series& a) noexcept {
  const Series one = constant(a.order, 1.0);
  return product(difference(one, a), sum(one, a));
}

Series square_less_one(const Series& a) noexcept { return scaled(one_less_square(a), -1.0); }

Series one_and_square(const Series& a) noexcept { return sum(product(a, a), constant(a.order, 1.0)); }

Series square_root(const Series& a) noexcept { return root(a, 0.5, std::sqrt(a[0])); }

Series result(const Step& step, const Series& a, double start) noexcept {
  const auto logarithm = [&](double base) { return integral_of_quotient(start, scaled(derivative(a), 1.0 / base), a); };
  const auto arc_sine = [&](const Series& b) {
    return integral_of_quotient(start, derivative(b), square_root(one_less_square(b)));
  };
  switch (step.operation) {
    case Operation::negate: return scaled(a, -1.0);
    case Operation::constant_power: return constant_power(a, step.number, start);
    case Operation::sin: return sine_like(a, start, std::cos(a[0]), -1.0).r;
    case Operation::cos: return sine_like(a, std::sin(a[0]), start, -1.0).p;
    case Operation::tan: return tangent_like(a, start, 1.0);
    case Operation::asin: return arc_sine(a);
    case Operation::acos: return arc_sine(scaled(a, -1.0));
    case Operation::atan: return integral_of_quotient(start, derivative(a), one_and_square(a));
    case Operation::sinh: return sine_like(a, start, std::cosh(a[0]), 1.0).r;
    case Operation::cosh: return sine_like(a, std::sinh(a[0]), start, 1.0).p;
    case Operation::tanh: return tangent_like(a, start, -1.0);
    case Operation::asinh: return integral_of_quotient(start, derivative(a), square_root(one_and_square(a)));
    case Operation::acosh: return integral_of_quotient(start, derivative(a), square_root(square_less_one(a)));
    case Operation::atanh: return integral_of_quotient(start, derivative(a), one_less_square(a));
    case Operation::exp: return exponential(a, start);
    case Operation::log: return logarithm(1.0);
    case Operation::log2: return logarithm(std::numbers::ln2);
    case Operation::log10: return logarithm(std::numbers::ln10);
    case Operation::sqrt: return root(a, 0.5, start);
    case Operation::cbrt: return root(a, 1.0 / 3.0, start);
    case Operation::abs: return absolute(a);
    case Operation::sign: return stepped(a, start, 0.0);
    case Operation::floor: return stepped(a, start, start);
    default: return missing_from(constant(a.order, start), 1);
  }
}

Series result(Operation operation, const Series& a, const Series& b, double start) noexcept {
  switch (operation) {
    case Operation::add: return sum(a, b);
    case Operation::subtract: return difference(a, b);
    case Operation::multiply: return product(a, b);
    case Operation::divide: return quotient(a, b);
    case Operation::power: return varying_power(a, b, start);
    case Operation::atan2: return arc_tangent(a, b, start);
    case Operation::min: return chosen(a, b, 1.0);
    case Operation::max: return chosen(a, b, -1.0);
    default: return missing_from(constant(a.order, start), 1);
  }
}

Series checked(Series series, double start) noexcept {
  series[0] = start;
  if (std::isnan(start)) return missing_from(series, 0);
  for (int k = 1; k <= series.order; ++k) {
    if (!std::isfinite(series[k])) series[k] = std::numeric_limits<double>::quiet_NaN();
  }
  return series;
}

}  // namespace

Series apply(const Step& step, const Series& a) noexcept {
  const double start = apply(step, a[0]);
  return checked(result(step, a, start), start);
}

Series apply(Operation operation, const Series& a, const Series& b) noexcept {
  const double start = apply(operation, a[0], b[0]);
  return checked(result(operation, a, b, start), start);
}

}  // namespace splinecore
