#include "point_matrix.hpp"

#include <cstddef>

#include "splinecore/base/pause.hpp"

namespace splinecore {

int copied_point(std::span<const double> row) noexcept {
  int copied = -1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == 0.0) continue;
    if (copied >= 0 || row[i] != 1.0) return -1;
    copied = static_cast<int>(i);
  }
  return copied;
}

std::size_t PointMatrix::old_index(std::size_t j, std::ptrdiff_t r) const noexcept {
  const std::ptrdiff_t count = from_.count();
  return ((rows_.first[j] + r) % count + count) % count;
}

void PointMatrix::apply(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                        std::size_t out_stride) const {
  constexpr std::size_t kBlock = 256;
  const std::ptrdiff_t width = rows_.width;
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    if (j % kBlock == 0) breathe(8 * kBlock * static_cast<std::size_t>(width));
    glm::dvec4 sum(0.0);
    const double* weights = rows_.weights.data() + j * width;
    for (std::ptrdiff_t r = 0; r < width; ++r) {
      if (weights[r] == 0.0) continue;
      const std::size_t index = from_.periodic() ? old_index(j, r) : static_cast<std::size_t>(rows_.first[j] + r);
      sum += weights[r] * points[index * stride];
    }
    out[j * out_stride] = sum;
  }
}

std::vector<glm::dvec4> PointMatrix::apply_transposed(const std::vector<glm::dvec4>& points) const {
  std::vector<glm::dvec4> out(from_.count(), glm::dvec4(0.0));
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    breathe(8 * static_cast<std::size_t>(rows_.width));
    for (std::ptrdiff_t r = 0; r < rows_.width; ++r) {
      const double weight = rows_.weights[j * rows_.width + r];
      if (weight != 0.0) out[old_index(j, r)] += weight * points[j];
    }
  }
  return out;
}

void PointMatrix::keep_untouched(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                                 std::size_t out_stride) const {
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    const int copied = copied_point(row(j));
    if (copied >= 0) out[j * out_stride] = points[old_index(j, copied) * stride];
  }
}

}  // namespace splinecore
