#pragma once

#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// The value of N_{i,degree} at any u of the whole line, also where the domain is empty.
///
/// Half-open spans, closed at the end of the domain (lecture row S14; Cox 1972, de Boor 1972;
/// The NURBS Book, A2.4). For a periodic vector the sum over all periods.
/// @throws InvalidShape if i is not in [0, count) or u is not finite.
double function_value(const KnotVector& knots, int i, double u);

/// Derivatives 0 … out.size() - 1 of N_{i,degree} at any u of the whole line (The NURBS Book, eq. 2.10).
///
/// Right-hand at a knot, left-hand at the end of the domain, as function_value(). For a periodic vector those
/// of the sum over all periods.
/// @throws InvalidShape if i is not in [0, count), u is not finite or the order is above kMaxOrder.
void function_derivatives(const KnotVector& knots, int i, double u, std::span<double> out);

/// The functions of one degree in the triangular scheme at a parameter.
///
/// Function first + j is rising[j] times the function first + j of one degree less plus falling[j] times its
/// neighbor first + j + 1. A factor is 0 where the row before has no such function: all of them lie in [0, 1].
/// In the first row both lists are empty.
struct TriangleRow {
  int first = 0;
  std::vector<double> values;
  std::vector<double> rising;
  std::vector<double> falling;
};

/// The triangle of Cox and de Boor (lecture row S14): for degrees 0 … degree the functions that are not zero on
/// the span of u, those that the knots have. Also where the domain is empty. The indices of a periodic vector
/// are those of unrolled(), less its degree.
/// @throws InvalidShape unless u lies in [first knot, last knot), or is the end of the domain.
std::vector<TriangleRow> function_triangle(const KnotVector& knots, double u);

/// The smallest interval outside which N_{i,degree} is zero.
Interval function_support(const KnotVector& knots, int i);

}  // namespace splinecore
