#include "quadrature.hpp"

#include <numbers>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

using Long = long double;

struct Legendre {
  Long value;
  Long slope;
};

/// Legendre's polynomial of degree kGaussNodes and its derivative, inside (-1, 1).
Legendre legendre(Long x) {
  Long before = 1.0L;
  Long value = x;
  for (std::size_t k = 2; k <= kGaussNodes; ++k) {
    const Long next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, kGaussNodes * (x * value - before) / (x * x - 1.0L)};
}

GaussRule made_rule() {
  GaussRule rule{};
  for (std::size_t i = 0; i < kGaussNodes; ++i) {
    Long x = -std::cos(std::numbers::pi_v<Long> * (i + 0.75L) / (kGaussNodes + 0.5L));
    for (int step = 0; step < 8; ++step) {
      const Legendre at = legendre(x);
      x -= at.value / at.slope;
    }
    const Long slope = legendre(x).slope;
    rule.nodes[i] = static_cast<double>(0.5L * (1.0L + x));
    rule.weights[i] = static_cast<double>(1.0L / ((1.0L - x * x) * slope * slope));
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_rule() {
  static const GaussRule rule = made_rule();
  return rule;
}

std::array<double, kGaussNodes> gauss_nodes(const Interval& interval) {
  std::array<double, kGaussNodes> nodes;
  for (std::size_t i = 0; i < kGaussNodes; ++i) nodes[i] = interval.start + interval.length() * gauss_rule().nodes[i];
  return nodes;
}

void require_relative(double tolerance) {
  if (tolerance > 0.0 && std::isfinite(tolerance)) return;
  throw InvalidShape("tolerance = " + text_of(tolerance) + " is not a positive number");
}

}  // namespace splinecore
