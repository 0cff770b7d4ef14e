#pragma once

#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parameters, in order, and weights that add up to 1: a sum over them is the mean of a function that is smooth between
/// breaks.
struct QuadratureNodes {
  std::vector<double> parameters;
  std::vector<double> weights;
};

/// So many of Gauss and Legendre between each two breaks. With ends, the first and last break are nodes, too, of the
/// weight of those beside them: for curves that are held there.
QuadratureNodes quadrature_nodes(std::span<const double> breaks, int count, bool with_ends);

/// How many of them integrate a product of two shapes of these degrees: exactly, where both are polynomial.
int node_count(int degree, int other, bool is_rational);

/// The distinct knots in the domains of both, which are equal.
std::vector<double> breaks_of(const KnotVector& a, const KnotVector& b);

/// Even knots for so many control points: clamped, or of period domain.length().
KnotVector even_knots(int degree, std::size_t count, const Interval& domain, bool is_periodic);

}  // namespace splinecore
#pragma GCC visibility pop
