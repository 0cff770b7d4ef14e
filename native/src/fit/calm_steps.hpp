#pragma once

#include <vector>

#include <cmath>

#pragma GCC visibility push(hidden)
namespace splinecore {

inline constexpr int kNoRoots = -1;

/// How often the root of a distance is taken for the step of a parameter beside which a curve of this degree stays near its
/// points. kNoRoots: steps are equal.
inline constexpr int calm_roots(int degree) noexcept {
  if (degree <= 3) return 1;
  return degree <= 5 ? degree - 2 : kNoRoots;
}

/// Parameters from 0 on in proportion, with another end: as long as what they are of, so that derivatives by the parameter
/// have the size of a direction. As they are where there is no such length.
std::vector<double> ending_at(std::vector<double> parameters, double length);

}  // namespace splinecore
#pragma GCC visibility pop
