#include "splinecore/basis/point_matrix.hpp"

#include "splinecore/base/pause.hpp"

namespace splinecore {

std::size_t PointMatrix::old_index(std::size_t j, long r) const noexcept {
  const long count = from_.count();
  return ((rows_.first[j] + r) % count + count) % count;
}

void PointMatrix::apply(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                        std::size_t out_stride) const {
  const long width = rows_.width;
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    glm::dvec4 sum(0.0);
    breathe(8 * static_cast<std::size_t>(width));
    for (long r = 0; r < width; ++r) {
      const double weight = rows_.weights[j * width + r];
      if (weight == 0.0) continue;
      const glm::dvec4& point = points[old_index(j, r) * stride];
      sum = weight == 1.0 ? point : sum + weight * point;
    }
    out[j * out_stride] = sum;
  }
}

std::vector<glm::dvec4> PointMatrix::apply_transposed(const std::vector<glm::dvec4>& points) const {
  std::vector<glm::dvec4> out(from_.count(), glm::dvec4(0.0));
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    breathe(8 * static_cast<std::size_t>(rows_.width));
    for (long r = 0; r < rows_.width; ++r) {
      const double weight = rows_.weights[j * rows_.width + r];
      if (weight != 0.0) out[old_index(j, r)] += weight * points[j];
    }
  }
  return out;
}

void PointMatrix::keep_untouched(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                                 std::size_t out_stride) const {
  for (std::size_t j = 0; j < rows_.first.size(); ++j) {
    for (long r = 0; r < rows_.width; ++r) {
      if (rows_.weights[j * rows_.width + r] == 1.0) out[j * out_stride] = points[old_index(j, r) * stride];
    }
  }
}

}  // namespace splinecore
