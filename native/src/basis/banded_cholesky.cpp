#include "banded_cholesky.hpp"

#include <algorithm>

#include "base/rounding.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

BandedCholesky::BandedCholesky(std::vector<double> rows, std::size_t width) : width_(width), rows_(std::move(rows)) {
  const std::size_t count = rows_.size() / width_;
  std::vector<double> before(count);
  for (std::size_t i = 0; i < count; ++i) before[i] = rows_[i * width_];
  for (std::size_t k = 0; k < count; ++k) {
    double* const row = rows_.data() + k * width_;
    if (!(row[0] > kRoundingOfShape * before[k])) {
      dependent_ = k;
      return;
    }
    const std::size_t reach = std::min(width_, count - k);
    breathe(reach * reach);
    for (std::size_t i = 1; i < reach; ++i) {
      const double factor = row[i] / row[0];
      if (factor == 0.0) continue;
      double* const to = row + i * width_;
      for (std::size_t j = i; j < reach; ++j) to[j - i] -= factor * row[j];
    }
  }
}

void BandedCholesky::solve(std::span<double> right, std::size_t columns) const {
  const std::size_t count = rows_.size() / width_;
  for (std::size_t k = 0; k < count; ++k) {
    const double* const row = rows_.data() + k * width_;
    const double* const from = right.data() + k * columns;
    breathe(width_ * columns);
    for (std::size_t i = 1; i < std::min(width_, count - k); ++i) {
      const double factor = row[i] / row[0];
      double* const to = right.data() + (k + i) * columns;
      for (std::size_t c = 0; c < columns; ++c) to[c] -= factor * from[c];
    }
  }
  for (std::size_t k = count; k-- > 0;) {
    const double* const row = rows_.data() + k * width_;
    double* const to = right.data() + k * columns;
    breathe(width_ * columns);
    for (std::size_t i = 1; i < std::min(width_, count - k); ++i) {
      const double* const from = right.data() + (k + i) * columns;
      for (std::size_t c = 0; c < columns; ++c) to[c] -= row[i] * from[c];
    }
    for (std::size_t c = 0; c < columns; ++c) to[c] /= row[0];
  }
}

}  // namespace splinecore
