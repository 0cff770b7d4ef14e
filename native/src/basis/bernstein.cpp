#include "splinecore/basis/bernstein.hpp"

#include <vector>

namespace splinecore {

namespace {

/// Pascal's triangle, row after row.
const double* binomial_row(int n) {
  static const std::vector<double> triangle = [] {
    std::vector<double> rows((kMaxDegree + 1) * (kMaxDegree + 2) / 2, 1.0);
    for (int i = 2, start = 3; i <= kMaxDegree; start += ++i) {
      for (int k = 1; k < i; ++k) rows[start + k] = rows[start - i + k - 1] + rows[start - i + k];
    }
    return rows;
  }();
  return triangle.data() + n * (n + 1) / 2;
}

}  // namespace

double binomial(int n, int k) { return binomial_row(n)[k]; }

void bernstein(int degree, double t, double s, std::span<double> out) {
  const double* choose = binomial_row(degree);
  double power = 1.0;
  for (int i = 0; i <= degree; ++i, power *= t) out[i] = choose[i] * power;
  power = s;
  for (int i = degree - 1; i >= 0; --i, power *= s) out[i] *= power;
}

}  // namespace splinecore
