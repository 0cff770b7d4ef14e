#pragma once

#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Nodes in (0, 1), in order, and weights that add up to 1.
struct GaussRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// The rule of Gauss and Legendre: exact up to degree 2 count - 1 (Davis and Rabinowitz 1984, §2.7; roots by Newton's
/// method).
GaussRule gauss_legendre(int count);

}  // namespace splinecore
#pragma GCC visibility pop
