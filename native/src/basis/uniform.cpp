#include "splinecore/basis/uniform.hpp"

#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// A polynomial with integer coefficients, lowest power first.
using IntegerPolynomial = std::vector<double>;

void require_degree(int degree, int most) {
  if (degree >= 0 && degree <= most) return;
  throw InvalidShape("degree = " + std::to_string(degree) + " is outside [0, " + std::to_string(most) + "]");
}

/// into += (constant + slope * t) * factor
void add_product(const IntegerPolynomial& factor, double constant, double slope, IntegerPolynomial& into) {
  for (std::size_t k = 0; k < factor.size(); ++k) {
    into[k] += constant * factor[k];
    into[k + 1] += slope * factor[k];
  }
}

/// degree! times the functions that are not zero on a span of knots one apart, by the recursion of row S14
/// with t from the span's start: function j begins degree - j knots before it.
std::vector<IntegerPolynomial> uniform_functions(int degree) {
  std::vector<IntegerPolynomial> functions{{1.0}};
  for (int p = 1; p <= degree; ++p) {
    std::vector<IntegerPolynomial> next(p + 1, IntegerPolynomial(p + 1));
    for (int j = 0; j < p; ++j) {
      add_product(functions[j], p - 1 - j, 1.0, next[j + 1]);
      add_product(functions[j], j + 1, -1.0, next[j]);
    }
    functions = std::move(next);
  }
  return functions;
}

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

}  // namespace

BasisMatrix uniform_matrix(int degree) {
  require_degree(degree, kMaxUniformDegree);
  BasisMatrix matrix{degree, {}};
  const std::vector<IntegerPolynomial> functions = uniform_functions(degree);
  for (int power = degree; power >= 0; --power) {
    for (const IntegerPolynomial& function : functions) matrix.values.push_back(function[power] / factorial(degree));
  }
  return matrix;
}

BasisMatrix uniform_to_bezier(int degree) {
  require_degree(degree, kMaxUniformDegree);
  BasisMatrix matrix{degree, {}};
  const std::vector<IntegerPolynomial> functions = uniform_functions(degree);
  for (int i = 0; i <= degree; ++i) {
    for (const IntegerPolynomial& function : functions) {
      double sum = 0.0;
      // The coefficient of t^k is divisible by C(degree, k): it comes from the k-th derivative.
      for (int k = 0; k <= i; ++k) sum += binomial(i, k) * (function[k] / binomial(degree, k));
      matrix.values.push_back(sum / factorial(degree));
    }
  }
  return matrix;
}

BasisMatrix bezier_matrix(int degree) {
  require_degree(degree, kMaxBezierMatrixDegree);
  BasisMatrix matrix{degree, {}};
  for (int power = degree; power >= 0; --power) {
    for (int j = 0; j <= degree; ++j) {
      const double size = j > power ? 0.0 : binomial(degree, power) * binomial(power, j);
      matrix.values.push_back((power - j) % 2 == 0 || size == 0.0 ? size : -size);
    }
  }
  return matrix;
}

BasisMatrix hermite_matrix() { return {3, {2, 1, -2, 1, -3, -2, 3, -1, 0, 1, 0, 0, 1, 0, 0, 0}}; }

}  // namespace splinecore
