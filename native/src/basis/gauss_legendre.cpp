#include "gauss_legendre.hpp"

#include <cmath>
#include <numbers>

namespace splinecore {

namespace {

struct Legendre {
  double value;
  double derivative;
};

/// Legendre's polynomial of this degree at x inside (-1, 1), by its recursion.
Legendre legendre(int degree, double x) {
  double before = 1.0;
  double value = x;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, degree * (before - x * value) / ((1.0 - x) * (1.0 + x))};
}

}  // namespace

GaussRule gauss_legendre(int count) {
  GaussRule rule{std::vector<double>(count), std::vector<double>(count)};
  for (int i = 0; i < (count + 1) / 2; ++i) {
    constexpr int kMostSteps = 20;
    double x = 2 * i + 1 == count ? 0.0 : std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    for (int step = 0; step < kMostSteps && x != 0.0; ++step) {
      const Legendre at = legendre(count, x);
      const double next = x - at.value / at.derivative;
      const bool is_done = std::abs(next - x) <= 1e-16;
      x = next;
      if (is_done) break;
    }
    const double slope = legendre(count, x).derivative;
    const double weight = 1.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
    rule.nodes[i] = 0.5 * (1.0 - x);
    rule.nodes[count - 1 - i] = 0.5 * (1.0 + x);
    rule.weights[i] = rule.weights[count - 1 - i] = weight;
  }
  return rule;
}

}  // namespace splinecore
