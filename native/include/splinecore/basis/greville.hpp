#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// For each control point the mean of the knots that decide it (Greville 1967): where it would lie on a straight line by the
/// parameter. Of degree 0 the middle of its span. Those of periodic knots are in one row, and may begin before the domain.
std::vector<double> greville_abscissae(const KnotVector& knots);

}  // namespace splinecore
