#include "splinecore/curve/transform.hpp"

#include "splinecore/base/points.hpp"

namespace splinecore {

NurbsCurve transformed(const NurbsCurve& curve, const glm::dmat4& matrix) {
  const bool is_affine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& point : points) {
    if (is_affine) {
      const glm::dvec4 image = matrix * glm::dvec4(glm::dvec3(point), point.w == 0.0 ? 0.0 : 1.0);
      point = glm::dvec4(glm::dvec3(image), point.w);
    } else {
      point = as_given(matrix * homogeneous(point));
    }
  }
  return curve.with_points(std::move(points));
}

}  // namespace splinecore
