#pragma once

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A node of (0, 1/2], its share in Kronrod's rule and that in Gauss's.
struct KronrodNode {
  double at;
  double kronrod;
  double gauss;
};

}  // namespace splinecore
#pragma GCC visibility pop
