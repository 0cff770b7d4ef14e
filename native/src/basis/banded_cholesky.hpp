#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A symmetric, positive definite matrix whose numbers are near the diagonal, factored once for any right sides (Golub
/// and Van Loan, §4.3.5).
class BandedCholesky {
 public:
  /// @param rows  the upper triangle: row i has `width` numbers from the diagonal on
  BandedCholesky(std::vector<double> rows, std::size_t width);

  /// The first row that those before it decide, up to rounding: the matrix is not definite, and solves nothing.
  std::optional<std::size_t> dependent_row() const noexcept { return dependent_; }

  /// Writes the solution over the right side, `columns` numbers a row.
  void solve(std::span<double> right, std::size_t columns) const;

 private:
  std::size_t width_;
  std::vector<double> rows_;
  std::optional<std::size_t> dependent_;
};

}  // namespace splinecore
#pragma GCC visibility pop
