#pragma once

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// The value of N_{i,degree} at any u of the whole line, also where the domain is empty.
///
/// Half-open spans, closed at the end of the domain (lecture row S14; Cox 1972, de Boor 1972;
/// The NURBS Book, A2.4). For a periodic vector the sum over all periods.
/// @throws InvalidShape if i is not in [0, count) or u is not finite.
double function_value(const KnotVector& knots, int i, double u);

/// The smallest interval outside which N_{i,degree} is zero.
Interval function_support(const KnotVector& knots, int i);

}  // namespace splinecore
