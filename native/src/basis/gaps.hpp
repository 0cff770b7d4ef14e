#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The parameters inside the domain where what stands on the knots may jump; of a period its start may be one.
inline std::vector<double> gaps(const KnotVector& knots) {
  std::vector<double> found;
  for (const int k : knots.spans()) {
    const double u = knots.unrolled()[k];
    const bool is_inside = knots.periodic() || u > knots.domain().start;
    if (is_inside && multiplicity(knots, u) > knots.degree()) found.push_back(u);
  }
  return found;
}

}  // namespace splinecore
#pragma GCC visibility pop
