#pragma once

#pragma GCC visibility push(hidden)
namespace splinecore {

/// 1 in the middle of [0, 1], and 0 at both ends with as many derivatives as the power, less one.
inline double bulge(double s, int power) {
  const double base = 4.0 * s * (1.0 - s);
  double value = base;
  for (int k = 1; k < power; ++k) value *= base;
  return value;
}

}  // namespace splinecore
#pragma GCC visibility pop
