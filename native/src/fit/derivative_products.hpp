#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A symmetric matrix of functions that share a span: in row i those with i - degree to i + degree, around a period.
struct ProductBand {
  explicit ProductBand(const KnotVector& knots);

  double at(std::size_t i, std::size_t k) const noexcept { return values[i * width + k]; }
  std::size_t partner(std::size_t i, std::size_t k) const noexcept { return (i + k + degree * (count - 1)) % count; }
  bool has(std::size_t i, std::size_t k) const noexcept {
    return is_periodic || (i + k >= degree && i + k < count + degree);
  }

  std::size_t count;
  std::size_t degree;
  std::size_t width;
  bool is_periodic;
  std::vector<double> values;
};

/// Integrals of products of derivatives of this order of the functions.
ProductBand derivative_products(const KnotVector& knots, int order);

// A derivative's control points are differences (The NURBS Book, §3.3), and so each integral is one of functions of a
// lower degree between differences. Where knots lie near each other the numbers of derivative_products() are so large
// that rounding them is as if what is straight were bent; differences of control points are not.

/// Integrals of products of the functions of the derivative of this order, which lie on the same knots.
ProductBand difference_products(const KnotVector& knots, int order);

/// The same over the spans that are not shorter than a length.
ProductBand difference_products_from(const KnotVector& knots, int order, double shortest);

/// By these the differences of control point i of the derivative of this order from the one before are control points of
/// the next derivative. None reaches over the ends, or over knots where a function ends before it starts.
std::vector<double> difference_steps(const KnotVector& knots, int order);

// Of `columns` numbers for each control point, into as many others.

/// The control points of the next derivative, by difference_steps().
void write_differences(std::span<const double> steps, std::size_t columns, std::span<const double> from,
                       std::span<double> to);

/// What write_differences() is, transposed.
void write_sums_of_differences(std::span<const double> steps, std::size_t columns, std::span<const double> from,
                               std::span<double> to);

void write_products(const ProductBand& band, std::size_t columns, std::span<const double> from, std::span<double> to);

}  // namespace splinecore
#pragma GCC visibility pop
