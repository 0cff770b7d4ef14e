#include "series_algebra.hpp"

#include <limits>

namespace splinecore {

Series constant(int order, double value) noexcept {
  Series series{order};
  series[0] = value;
  return series;
}

Series missing_from(Series a, int first) noexcept {
  for (int k = first; k <= a.order; ++k) a[k] = std::numeric_limits<double>::quiet_NaN();
  return a;
}

int leading(const Series& a) noexcept {
  int k = 0;
  while (k <= a.order && a[k] == 0.0) ++k;
  return k;
}

Series scaled(Series a, double factor) noexcept {
  for (int k = 0; k <= a.order; ++k) a[k] *= factor;
  return a;
}

Series sum(Series a, const Series& b) noexcept {
  for (int k = 0; k <= a.order; ++k) a[k] += b[k];
  return a;
}

Series difference(Series a, const Series& b) noexcept {
  for (int k = 0; k <= a.order; ++k) a[k] -= b[k];
  return a;
}

Series product(const Series& a, const Series& b) noexcept {
  Series out{a.order};
  for (int k = 0; k <= a.order; ++k) {
    for (int j = 0; j <= k; ++j) out[k] += a[j] * b[k - j];
  }
  return out;
}

Series quotient(const Series& a, const Series& b) noexcept {
  Series out{a.order};
  for (int k = 0; k <= a.order; ++k) {
    double rest = a[k];
    for (int j = 1; j <= k; ++j) rest -= b[j] * out[k - j];
    out[k] = rest / b[0];
  }
  return out;
}

Series derivative(const Series& a) noexcept {
  Series out{a.order};
  for (int k = 1; k <= a.order; ++k) out[k - 1] = k * a[k];
  return out;
}

Series integral_of_quotient(double start, const Series& a, const Series& b) noexcept {
  Series r = constant(a.order, start);
  for (int k = 1; k <= a.order; ++k) {
    double rest = a[k - 1];
    for (int j = 1; j < k; ++j) rest -= j * r[j] * b[k - j];
    r[k] = rest / (k * b[0]);
  }
  return r;
}

double integral_of_product(const Series& a, const Series& b, int k) noexcept {
  double total = 0.0;
  for (int j = 1; j <= k; ++j) total += j * a[j] * b[k - j];
  return total / k;
}

}  // namespace splinecore
