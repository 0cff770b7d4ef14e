#include "bending.hpp"

#include <cmath>

namespace splinecore {

namespace {

/// ln of n over k: products of binomials of degree 255 would overflow.
double log_binomial(int n, int k) { return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0); }

/// Row i: the factors of Bezier points i, i + 1, … in difference i of this order, times degree … (degree - order + 1).
std::vector<double> differences(int degree, int order) {
  std::vector<double> row(order + 1, 0.0);
  row[0] = 1.0;
  for (int k = 0; k < order; ++k) {
    for (int j = k + 1; j > 0; --j) row[j] = row[j - 1] - row[j];
    row[0] = -row[0];
    for (double& factor : row) factor *= degree - k;
  }
  return row;
}

}  // namespace

std::vector<double> bending_matrix(int degree, int order) {
  const int width = degree + 1;
  std::vector<double> matrix(static_cast<std::size_t>(width) * width, 0.0);
  if (order > degree) return matrix;
  const int rest = degree - order;
  const std::vector<double> factors = differences(degree, order);
  for (int i = 0; i <= rest; ++i) {
    for (int j = 0; j <= rest; ++j) {
      const double product =
          std::exp(log_binomial(rest, i) + log_binomial(rest, j) - log_binomial(2 * rest, i + j)) / (2 * rest + 1);
      for (int a = 0; a <= order; ++a) {
        for (int b = 0; b <= order; ++b) matrix[(i + a) * width + j + b] += product * factors[a] * factors[b];
      }
    }
  }
  return matrix;
}

}  // namespace splinecore
