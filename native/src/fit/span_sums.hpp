#pragma once

#include <cstddef>
#include <span>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parameters in one span of knots.
struct SpanParameters {
  int degree;
  Interval span;
  std::span<const double> parameters;
  std::span<const double> weights;  ///< of squares, or none for 1 each
  double weight_scale;              ///< by which they are multiplied
};

/// Sums of weight times the products of two Bernstein polynomials: the upper triangle of a matrix, row after row.
void write_products(const SpanParameters& at, std::span<double> matrix);

/// Sums of weight times Bernstein polynomial times what is left of the values by a piece, `columns` numbers each.
/// @param piece  Bezier points
void write_residuals(const SpanParameters& at, std::span<const double> values, std::size_t columns,
                     std::span<const double> piece, std::span<double> sums);

/// The same of three columns.
/// @returns the square of the largest distance times the scale
double write_residuals(const SpanParameters& at, std::span<const double> values, std::span<const double> piece,
                       double scale, std::span<double> sums);

}  // namespace splinecore
#pragma GCC visibility pop
