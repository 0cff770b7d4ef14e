#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Control points of one number from its values at greville_places() in both directions, row after row.
std::vector<double> grid_controls(const KnotVector& u, const KnotVector& v, const std::vector<double>& values);

}  // namespace splinecore
#pragma GCC visibility pop
