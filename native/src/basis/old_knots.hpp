#pragma once

#include <cstddef>
#include <vector>

#include "periodic_knots.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The knots that a window of a new vector can reach; begin is the index of the first.
struct OldKnots {
  std::ptrdiff_t begin = 0;
  std::vector<double> values;
  const double* at(std::ptrdiff_t i) const { return values.data() + (i - begin); }
};

/// All of a plain vector; of a periodic one, a period and `margin` knots more on each side.
inline OldKnots reachable(const KnotVector& knots, std::ptrdiff_t margin) {
  const auto given = knots.knots();
  if (!knots.periodic()) return {0, {given.begin(), given.end()}};
  OldKnots old{-margin, {}};
  for (std::ptrdiff_t i = -margin; i <= knots.count() + margin; ++i) old.values.push_back(periodic_knot(given, i));
  return old;
}

}  // namespace splinecore
#pragma GCC visibility pop
