#pragma once

#include <string>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// The parameters of a Hermite chain: as given, or 0, 1, 2, … where empty.
/// @throws InvalidShape if there are fewer than 2, their number is not count, or they do not increase.
std::vector<double> hermite_parameters(std::vector<double> parameters, std::size_t count,
                                       const std::string& argument);

/// Cubic knots for a chain of Bezier segments: triple at each parameter, fourfold at the ends.
KnotVector hermite_knots(const std::vector<double>& parameters);

}  // namespace splinecore
