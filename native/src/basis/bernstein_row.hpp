#pragma once

#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Values and slopes of the Bernstein polynomials at one place.
struct BernsteinRow {
  BernsteinRow(int degree, double t);
  std::vector<double> values;
  std::vector<double> slopes;
};

}  // namespace splinecore
#pragma GCC visibility pop
