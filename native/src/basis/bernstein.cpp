#include "splinecore/basis/bernstein.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace splinecore {

namespace {

/// The last row of the table: that of products of two polynomials, and of three. C(765, 382) is about 1e229.
constexpr int kLastOfTwo = 2 * kMaxDegree;
constexpr int kLastOfThree = 3 * kMaxDegree;

/// Pascal's triangle, row after row.
std::vector<double> triangle(int last) {
  std::vector<double> rows((last + 1) * (last + 2) / 2, 1.0);
  for (int i = 2, start = 3; i <= last; start += ++i) {
    for (int k = 1; k < i; ++k) rows[start + k] = rows[start - i + k - 1] + rows[start - i + k];
  }
  return rows;
}

const double* binomial_row(int n) {
  if (n < 0 || n > kLastOfThree) throw std::out_of_range("no row " + std::to_string(n) + " of binomials");
  const int before = n * (n + 1) / 2;
  static const std::vector<double> of_two = triangle(kLastOfTwo);
  if (n <= kLastOfTwo) return of_two.data() + before;
  static const std::vector<double> of_three = triangle(kLastOfThree);
  return of_three.data() + before;
}

}  // namespace

const double* binomials(int degree) noexcept { return binomial_row(degree); }

double binomial(int n, int k) {
  const double* row = binomial_row(n);
  if (k < 0 || k > n) throw std::out_of_range("no binomial " + std::to_string(k) + " in row " + std::to_string(n));
  return row[k];
}

void bernstein(int degree, double t, double s, std::span<double> out) {
  const double* choose = binomial_row(degree);
  double power = 1.0;
  for (int i = 0; i <= degree; ++i, power *= t) out[i] = choose[i] * power;
  power = s;
  for (int i = degree - 1; i >= 0; --i, power *= s) out[i] *= power;
}

}  // namespace splinecore
