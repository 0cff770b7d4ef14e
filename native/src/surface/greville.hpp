#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Means of the knots that decide each control point (Greville 1967), in the domain and in order.
std::vector<double> greville_places(const KnotVector& knots);

/// Places at which splines go nearly as close by a function as they can: Greville's; of one span the zeros of Chebyshev's
/// polynomial, stretched to both ends (de Boor, A Practical Guide to Splines, II).
std::vector<double> interpolation_places(const KnotVector& knots);

/// The same where derivatives are given at both ends, too.
std::vector<double> interpolation_places_between_slopes(const KnotVector& knots);

}  // namespace splinecore
#pragma GCC visibility pop
