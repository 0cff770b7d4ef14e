#pragma once

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A parameter of a periodic shape in its first period, where it goes on at the end.
inline double within_period(double u, const KnotVector& knots) {
  const Interval domain = knots.domain();
  const bool is_seam = knots.periodic() && u == domain.end && multiplicity(knots, domain.end) <= knots.degree();
  return is_seam ? domain.start : u;
}

}  // namespace splinecore
#pragma GCC visibility pop
