#include "bending.hpp"

#include <algorithm>
#include <utility>

namespace splinecore {

Bending::Bending(const KnotVector& knots)
    : between_(difference_products(knots, 2)), steps_{difference_steps(knots, 0), difference_steps(knots, 1)} {}

std::vector<double> Bending::slope(std::span<const double> controls, std::size_t columns) const {
  const std::size_t count = between_.count;
  std::vector<double> from(controls.begin(), controls.end());
  std::vector<double> to(from.size());
  for (const std::vector<double>& steps : steps_) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i > 0 ? i : count) - 1;
      for (std::size_t c = 0; c < columns; ++c) {
        to[i * columns + c] = steps[i] * (from[i * columns + c] - from[before * columns + c]);
      }
    }
    std::swap(from, to);
  }
  std::ranges::fill(to, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < between_.width; ++k) {
      if (!between_.has(i, k)) continue;
      const double* const other = &from[between_.partner(i, k) * columns];
      for (std::size_t c = 0; c < columns; ++c) to[i * columns + c] += between_.at(i, k) * other[c];
    }
  }
  std::swap(from, to);
  for (auto steps = steps_.rbegin(); steps != steps_.rend(); ++steps) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t after = i + 1 < count ? i + 1 : 0;
      for (std::size_t c = 0; c < columns; ++c) {
        to[i * columns + c] = (*steps)[i] * from[i * columns + c] - (*steps)[after] * from[after * columns + c];
      }
    }
    std::swap(from, to);
  }
  return from;
}

}  // namespace splinecore
