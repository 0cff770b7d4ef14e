#include "gram.hpp"

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

void add_piece_products(const KnotVector& knots, std::size_t span, std::span<const double> matrix,
                        std::span<double> products) {
  const std::size_t width = static_cast<std::size_t>(knots.degree()) + 1;
  const auto count = static_cast<std::size_t>(knots.count());
  const SquareRows piece = knots.bezier_matrix(static_cast<int>(span));
  std::vector<double> half(width * width, 0.0);
  for (std::size_t j = 0; j < width; ++j) {
    for (std::size_t l = 0; l < width; ++l) {
      for (std::size_t b = 0; b < width; ++b) half[j * width + b] += matrix[j * width + l] * piece[l][b];
    }
  }
  const auto first = static_cast<std::size_t>(knots.spans()[span]) - (width - 1);
  for (std::size_t a = 0; a < width; ++a) {
    double* const to = &products[(first + a) % count * width];
    for (std::size_t b = a; b < width; ++b) {
      for (std::size_t j = 0; j < width; ++j) to[b - a] += piece[j][a] * half[j * width + b];
    }
  }
}

std::vector<double> gram_rows(const KnotVector& knots, int order) {
  const std::size_t width = static_cast<std::size_t>(knots.degree()) + 1;
  std::vector<double> rows(static_cast<std::size_t>(knots.count()) * width, 0.0);
  const std::vector<double> unit = bending_matrix(knots.degree(), order);
  std::vector<double> scaled(unit.size());
  for (std::size_t s = 0; s < knots.spans().size(); ++s) {
    const double factor = std::pow(knots.span_interval(static_cast<int>(s)).length(), 1 - 2 * order);
    for (std::size_t k = 0; k < unit.size(); ++k) scaled[k] = factor * unit[k];
    add_piece_products(knots, s, scaled, rows);
  }
  return rows;
}

}  // namespace splinecore
