#include "banded.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

[[noreturn]] void refuse() {
  throw InvalidShape("the conditions do not determine the shape, or contradict each other");
}

/// A band in rows of equal width: row i has the columns from i - lower on, with room for what exchanges fill.
class Band {
 public:
  Band(std::size_t count, std::ptrdiff_t lower, std::ptrdiff_t upper)
      : count_(static_cast<std::ptrdiff_t>(count)), lower_(lower), upper_(std::min(upper + lower, count_ - 1)),
        width_(lower_ + upper_ + 1), values_(count * static_cast<std::size_t>(width_)) {}

  double& at(std::ptrdiff_t i, std::ptrdiff_t j) {
    return values_[static_cast<std::size_t>(i * width_ + j - i + lower_)];
  }

  /// Writes X over the right side.
  void solve(double* right, std::size_t columns) {
    for (std::ptrdiff_t k = 0; k < count_; ++k) {
      breathe(static_cast<std::size_t>(lower_ + 1) * (static_cast<std::size_t>(upper_) + columns));
      const std::ptrdiff_t last = std::min(count_ - 1, k + lower_);
      take_pivot(k, last, right, columns);
      for (std::ptrdiff_t i = k + 1; i <= last; ++i) eliminate(k, i, right, columns);
    }
    for (std::ptrdiff_t k = count_ - 1; k >= 0; --k) {
      breathe(static_cast<std::size_t>(upper_ + 1) * columns);
      substitute(k, right, columns);
    }
  }

 private:
  /// Exchanges row k for the one below that has the largest number in its column, if its own is far smaller.
  void take_pivot(std::ptrdiff_t k, std::ptrdiff_t last, double* right, std::size_t columns) {
    constexpr double kMuchSmaller = 0.1;
    std::ptrdiff_t best = k;
    for (std::ptrdiff_t i = k + 1; i <= last; ++i) {
      if (std::abs(at(i, k)) > std::abs(at(best, k))) best = i;
    }
    if (!(std::abs(at(best, k)) > 0.0)) refuse();
    if (std::abs(at(k, k)) >= kMuchSmaller * std::abs(at(best, k))) return;
    for (std::ptrdiff_t j = k; j <= std::min(count_ - 1, k + upper_); ++j) std::swap(at(k, j), at(best, j));
    std::swap_ranges(right + k * columns, right + (k + 1) * columns, right + best * columns);
  }

  void eliminate(std::ptrdiff_t k, std::ptrdiff_t i, double* right, std::size_t columns) {
    if (at(i, k) == 0.0) return;
    const double factor = at(i, k) / at(k, k);
    const std::ptrdiff_t end = std::min(count_ - 1, k + upper_);
    const double* const from = &at(k, k);
    double* const to = &at(i, k);
    for (std::ptrdiff_t j = 1; j <= end - k; ++j) to[j] -= factor * from[j];
    for (std::size_t c = 0; c < columns; ++c) right[i * columns + c] -= factor * right[k * columns + c];
  }

  void substitute(std::ptrdiff_t k, double* right, std::size_t columns) {
    double* const row = right + k * columns;
    const std::ptrdiff_t end = std::min(count_ - 1, k + upper_);
    for (std::ptrdiff_t j = k + 1; j <= end; ++j) {
      const double factor = at(k, j);
      for (std::size_t c = 0; c < columns; ++c) row[c] -= factor * right[j * columns + c];
    }
    for (std::size_t c = 0; c < columns; ++c) row[c] /= at(k, k);
  }

  std::ptrdiff_t count_;
  std::ptrdiff_t lower_;
  std::ptrdiff_t upper_;
  std::ptrdiff_t width_;
  std::vector<double> values_;
};

/// How far the rows of some reach to each side of the diagonal, among the columns below `count`.
struct Reach {
  std::ptrdiff_t lower = 0;
  std::ptrdiff_t upper = 0;

  void add(std::ptrdiff_t i, std::ptrdiff_t j) {
    lower = std::max(lower, i - j);
    upper = std::max(upper, j - i);
  }
};

}  // namespace

void solve_banded(const BandedRows& matrix, std::span<double> right, std::size_t columns) {
  const auto count = static_cast<std::ptrdiff_t>(matrix.count());
  Reach reach;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    reach.add(i, matrix.first[i]);
    reach.add(i, std::min(matrix.first[i] + static_cast<std::ptrdiff_t>(matrix.width), count) - 1);
  }
  Band band(matrix.count(), reach.lower, reach.upper);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto row = matrix.row(i);
    for (std::size_t j = 0; j < row.size(); ++j) {
      const std::ptrdiff_t column = matrix.first[i] + static_cast<std::ptrdiff_t>(j);
      if (column < count) band.at(i, column) = row[j];
    }
  }
  band.solve(right.data(), columns);
}

namespace {

/// The triangle that rotations make of rows with a short band and a tail: the columns that rows reach over the end.
class TriangularFactor {
 public:
  TriangularFactor(std::size_t count, std::size_t width, std::size_t columns)
      : inner_(count - std::min(count, width - 1)), width_(width), tail_(count - inner_), columns_(columns),
        stride_(width + tail_ + columns), rows_(count * stride_, 0.0), is_there_(count, false) {}

  std::size_t stride() const noexcept { return stride_; }
  std::size_t inner() const noexcept { return inner_; }

  /// Takes up a row: `width` numbers from column `first` on, the tail, the right sides. It is written over.
  void add(std::size_t first, double* row) {
    std::size_t column = first;
    for (; column < inner_; ++column) {
      breathe(4 * stride_);
      if (keep_or_rotate(column, row, row)) return;
      std::shift_left(row, row + width_, 1);
      row[width_ - 1] = 0.0;
    }
    for (; column < inner_ + tail_; ++column) {
      if (keep_or_rotate(column, row + width_ + (column - inner_), row)) return;
    }
  }

  /// Row after row.
  void solve(double* out) const {
    for (std::size_t i = inner_ + tail_; i-- > 0;) {
      breathe(width_ + tail_ + columns_);
      if (diagonal(i) == 0.0) refuse();
      substitute(i, out);
    }
  }

 private:
  const double* at(std::size_t i) const { return rows_.data() + i * stride_; }
  double* at(std::size_t i) { return rows_.data() + i * stride_; }
  double diagonal(std::size_t i) const { return at(i)[i < inner_ ? 0 : width_ + (i - inner_)]; }

  /// Whether the row was kept; else its number in this column is rotated into the row that is there.
  bool keep_or_rotate(std::size_t column, double* lead, double* row) {
    if (*lead == 0.0) return false;
    double* const kept = at(column);
    if (!is_there_[column]) {
      std::copy_n(row, stride_, kept);
      is_there_[column] = true;
      return true;
    }
    const double before = kept[lead - row];
    const double length = std::hypot(before, *lead);
    const double cosine = before / length;
    const double sine = *lead / length;
    for (std::size_t k = static_cast<std::size_t>(lead - row); k < stride_; ++k) {
      const double old = kept[k];
      kept[k] = cosine * old + sine * row[k];
      row[k] = cosine * row[k] - sine * old;
    }
    return false;
  }

  void substitute(std::size_t i, double* out) const {
    const double* const row = at(i);
    for (std::size_t c = 0; c < columns_; ++c) {
      double sum = row[width_ + tail_ + c];
      for (std::size_t k = 1; k < width_ && i + k < inner_; ++k) sum -= row[k] * out[(i + k) * columns_ + c];
      for (std::size_t k = i < inner_ ? 0 : i - inner_ + 1; k < tail_; ++k) {
        sum -= row[width_ + k] * out[(inner_ + k) * columns_ + c];
      }
      out[i * columns_ + c] = sum / diagonal(i);
    }
  }

  std::size_t inner_;
  std::size_t width_;
  std::size_t tail_;
  std::size_t columns_;
  std::size_t stride_;
  std::vector<double> rows_;
  std::vector<bool> is_there_;
};

}  // namespace

void solve_cyclic(const BandedRows& matrix, std::span<double> right, std::size_t columns) {
  const std::size_t count = matrix.count();
  TriangularFactor triangle(count, matrix.width, columns);
  const std::size_t inner = triangle.inner();
  std::vector<double> row(triangle.stride());
  const auto add_if = [&](bool wanted) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto first = static_cast<std::size_t>(matrix.first[i]) % count;
      const bool returns = first + matrix.width > count;
      if (returns != wanted) continue;
      std::ranges::fill(row, 0.0);
      const std::size_t begin = returns ? 0 : first;
      for (std::size_t j = 0; j < matrix.width; ++j) {
        const std::size_t column = (first + j) % count;
        row[column < inner ? column - begin : matrix.width + (column - inner)] += matrix.row(i)[j];
      }
      std::copy_n(right.data() + i * columns, columns, row.end() - static_cast<std::ptrdiff_t>(columns));
      triangle.add(begin, row.data());
    }
  };
  add_if(false);
  add_if(true);
  triangle.solve(right.data());
}

}  // namespace splinecore
