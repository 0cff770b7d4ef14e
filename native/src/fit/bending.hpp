#pragma once

#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The integral over [0, 1] of the product of two derivatives of this order, as a symmetric matrix over the degree + 1
/// Bezier points of a piece, row after row: derivatives by differences, products by Farouki and Rajan (1988, eq. 46).
/// Zero where the order is above the degree.
std::vector<double> bending_matrix(int degree, int order);

}  // namespace splinecore
#pragma GCC visibility pop
