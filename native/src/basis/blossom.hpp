#pragma once

#include <span>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Weights over control points i, i + 1, … of the blossom that has the given arguments and, for
/// the rest of its `degree` arguments, the knots that all these points share.
///
/// Point i has the knots t[1] … t[degree]; arguments.size() + 1 points take part, and row gets
/// as many weights. While the arguments lie between the knots next to the shared ones, every
/// factor lies in [0, 1] (Ramshaw 1989; the triangle is that of The NURBS Book, A2.2).
void blossom_weights(const double* t, int degree, std::span<const double> arguments, double* row);

}  // namespace splinecore
#pragma GCC visibility pop
