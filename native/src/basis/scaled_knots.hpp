#pragma once

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Knots divided by 2^exponent.
struct ScaledKnots {
  int exponent;
  KnotVector knots;
};

}  // namespace splinecore
#pragma GCC visibility pop
