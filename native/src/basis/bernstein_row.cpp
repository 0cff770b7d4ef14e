#include "bernstein_row.hpp"

#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

BernsteinRow::BernsteinRow(int degree, double t) : values(degree + 1), slopes(degree + 1, 0.0) {
  bernstein(degree, t, 1.0 - t, values);
  std::vector<double> lower(degree);
  bernstein(degree - 1, t, 1.0 - t, lower);
  for (int i = 0; i < degree; ++i) {
    slopes[i] -= degree * lower[i];
    slopes[i + 1] += degree * lower[i];
  }
}

}  // namespace splinecore
