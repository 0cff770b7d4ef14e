#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Means of the knots that decide each control point (Greville 1967), in the domain and in order.
std::vector<double> greville_places(const KnotVector& knots);

}  // namespace splinecore
#pragma GCC visibility pop
