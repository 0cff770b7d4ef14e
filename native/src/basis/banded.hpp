#pragma once

#include <cstddef>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A square matrix whose rows are few numbers near the diagonal: row i has `width` of them, from column first[i] on.
struct BandedRows {
  std::size_t width = 0;
  std::vector<std::ptrdiff_t> first;     ///< where columns repeat, a row may reach behind the last one
  std::vector<double> values;  ///< row after row

  std::size_t count() const noexcept { return first.size(); }
  std::span<double> row(std::size_t i) noexcept { return {values.data() + i * width, width}; }
  std::span<const double> row(std::size_t i) const noexcept { return {values.data() + i * width, width}; }
};

/// Solves A X = B for all columns of B at once, in time linear in the rows: Gaussian elimination within the band
/// (Golub and Van Loan, §4.3.5), with rows exchanged only where a pivot is small. Matrices of B-spline functions need
/// none (de Boor and Pinkus 1977).
/// @param right    B, row after row, `columns` numbers each; X is written to it
/// @throws InvalidShape if a pivot is zero; a matrix that is nearly singular leaves X to rounding.
void solve_banded(const BandedRows& matrix, std::span<double> right, std::size_t columns);

/// The same where columns repeat after count(), and the diagonal may be anywhere: rotations (Givens), as Dierckx (1993,
/// §4.1.2) has them for periodic splines. Linear in time where rows are in the order of their first columns.
void solve_cyclic(const BandedRows& matrix, std::span<double> right, std::size_t columns);

}  // namespace splinecore
#pragma GCC visibility pop
