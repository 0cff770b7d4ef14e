#include "splinecore/basis/functions.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

void require_function(const KnotVector& knots, int i) {
  if (i >= 0 && i < knots.count()) return;
  throw InvalidShape("i = " + std::to_string(i) + " is outside [0, " +
                     std::to_string(knots.count() - 1) + "]");
}

/// Cox and de Boor's recursion on the degree + 2 knots of one function.
double cox_de_boor(std::span<const double> knots, double u, bool closed_at_u) {
  const int degree = static_cast<int>(knots.size()) - 2;
  std::vector<double> values(degree + 1);
  breathe(4 * values.size() * values.size());
  for (int j = 0; j <= degree; ++j) {
    values[j] = closed_at_u ? (knots[j] < u && u <= knots[j + 1])
                            : (knots[j] <= u && u < knots[j + 1]);
  }
  for (int level = 1; level <= degree; ++level) {
    for (int j = 0; j <= degree - level; ++j) {
      const double rise = knots[j + level] - knots[j];
      const double fall = knots[j + level + 1] - knots[j + 1];
      const double rising = values[j] == 0.0 ? 0.0 : (u - knots[j]) / rise * values[j];
      const double falling =
          values[j + 1] == 0.0 ? 0.0 : (knots[j + level + 1] - u) / fall * values[j + 1];
      values[j] = rising + falling;
    }
  }
  return values[0];
}

/// Derivatives of the only function of these knots by differences of functions of lower degree, whose
/// factors stand in a triangle: row k holds those of degree - k.
void derive(std::span<const double> knots, double u, bool closed_at_u, std::span<double> out) {
  const int degree = static_cast<int>(knots.size()) - 2;
  std::vector<double> factors{1.0};
  std::ranges::fill(out, 0.0);
  for (int k = 0; k <= degree && k < static_cast<int>(out.size()); ++k) {
    const int lower = degree - k;
    for (int j = 0; j <= k; ++j) {
      if (factors[j] != 0.0) out[k] += factors[j] * cox_de_boor(knots.subspan(j, lower + 2), u, closed_at_u);
    }
    std::vector<double> next(k + 2);
    for (int j = 0; j <= k; ++j) {
      const double whole = knots[j + lower] - knots[j];
      const double whole_after = knots[j + lower + 1] - knots[j + 1];
      if (whole != 0.0) next[j] += lower * factors[j] / whole;
      if (whole_after != 0.0) next[j + 1] -= lower * factors[j] / whole_after;
    }
    factors = std::move(next);
  }
}

double periodic_value(const KnotVector& knots, int i, double u, int order = 0) {
  const Samples sample = Samples::make(knots, {&u, 1}, order);
  double sum = 0.0;
  for (int j = 0; j <= knots.degree(); ++j) {
    if ((sample.first(0) + j) % knots.count() == i) sum += sample.weights(0, order)[j];
  }
  return sum;
}

bool is_domain_end(const KnotVector& knots, double u) { return knots.has_domain() && u == knots.domain().end; }

}  // namespace

double function_value(const KnotVector& knots, int i, double u) {
  require_function(knots, i);
  if (!std::isfinite(u)) throw InvalidShape("u = " + text_of(u) + " is not finite");
  if (knots.periodic()) return periodic_value(knots, i, u);
  return cox_de_boor(knots.knots().subspan(i, knots.degree() + 2), u, is_domain_end(knots, u));
}

void function_derivatives(const KnotVector& knots, int i, double u, std::span<double> out) {
  require_function(knots, i);
  require_order(static_cast<int>(out.size()) - 1);
  if (!std::isfinite(u)) throw InvalidShape("u = " + text_of(u) + " is not finite");
  if (!knots.periodic()) return derive(knots.knots().subspan(i, knots.degree() + 2), u, is_domain_end(knots, u), out);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = periodic_value(knots, i, u, static_cast<int>(k));
}

Interval function_support(const KnotVector& knots, int i) {
  require_function(knots, i);
  return {knots.unrolled()[i], knots.unrolled()[i + knots.degree() + 1]};
}

}  // namespace splinecore
