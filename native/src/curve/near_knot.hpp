#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How far knots of a domain may be apart that are one but for rounding, as a part of it: by more where it lies far from zero.
inline double knot_rounding(Interval domain) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  return kRounding * std::max(std::abs(domain.start), std::abs(domain.end)) / domain.length();
}

/// The knot that lies nearest to a parameter, if one lies within a distance; else the parameter.
inline double near_knot(const KnotVector& knots, double u, double distance) {
  double found = u;
  double least = distance;
  for (const double knot : knots.knots()) {
    if (!(std::abs(knot - u) <= least)) continue;
    least = std::abs(knot - u);
    found = knot;
  }
  return found;
}

}  // namespace splinecore
#pragma GCC visibility pop
