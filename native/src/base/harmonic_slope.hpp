#pragma once

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The slope, between two secants, of a curve that does not leave what lies between its points: their harmonic mean, or 0 where
/// one rises and the other falls (Fritsch and Butland 1984).
inline double harmonic_slope(double a, double b) {
  return (a > 0.0) == (b > 0.0) && a != 0.0 ? 2.0 * (a / (a + b)) * b : 0.0;
}

}  // namespace splinecore
#pragma GCC visibility pop
