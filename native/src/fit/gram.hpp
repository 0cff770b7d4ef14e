#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The integral over [0, 1] of the product of two derivatives of this order, as a symmetric matrix over the degree + 1
/// Bezier points of a piece, row after row: derivatives by differences, products by Farouki and Rajan (1988, eq. 46).
/// Zero where the order is above the degree.
std::vector<double> bending_matrix(int degree, int order);

/// Adds what a symmetric matrix of a span's Bernstein polynomials is of its functions.
/// @param products  row i: of function i with itself and the next `degree` ones
void add_piece_products(const KnotVector& knots, std::size_t span, std::span<const double> matrix,
                        std::span<double> products);

/// The integrals of products of the functions' derivatives of an order over the domain, in such rows.
std::vector<double> gram_rows(const KnotVector& knots, int order);

}  // namespace splinecore
#pragma GCC visibility pop
