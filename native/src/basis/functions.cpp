#include "splinecore/basis/functions.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "splinecore/base/errors.hpp"
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

double periodic_value(const KnotVector& knots, int i, double u) {
  const Samples sample = Samples::make(knots, {&u, 1});
  double sum = 0.0;
  for (int j = 0; j <= knots.degree(); ++j) {
    if ((sample.first(0) + j) % knots.count() == i) sum += sample.weights(0)[j];
  }
  return sum;
}

}  // namespace

double function_value(const KnotVector& knots, int i, double u) {
  require_function(knots, i);
  if (!std::isfinite(u)) throw InvalidShape("u = " + text_of(u) + " is not finite");
  if (knots.periodic()) return periodic_value(knots, i, u);
  const bool at_domain_end = knots.has_domain() && u == knots.domain().end;
  return cox_de_boor(knots.knots().subspan(i, knots.degree() + 2), u, at_domain_end);
}

Interval function_support(const KnotVector& knots, int i) {
  require_function(knots, i);
  return {knots.unrolled()[i], knots.unrolled()[i + knots.degree() + 1]};
}

}  // namespace splinecore
