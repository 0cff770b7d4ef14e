#include "splinecore/curve/transform.hpp"

#include <glm/vec3.hpp>

#include "base/given_points.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

std::vector<glm::dvec4> transformed(std::span<const glm::dvec4> given, const glm::dmat4& matrix) {
  const bool is_affine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
  const bool is_rational = splinecore::is_rational(given);
  const int exponent = is_rational && !is_affine ? weight_exponent(given) : 0;
  std::vector<glm::dvec4> points(given.begin(), given.end());
  if (is_affine) {
    for (glm::dvec4& point : points) {
      const glm::dvec4 image = matrix * glm::dvec4(glm::dvec3(point), point.w == 0.0 ? 0.0 : 1.0);
      point = glm::dvec4(glm::dvec3(image), point.w);
    }
    return points;
  }
  points = homogeneous(given, exponent);
  for (glm::dvec4& point : points) point = matrix * point;
  return as_given_from(given, true, exponent, points).made;
}

NurbsCurve transformed(const NurbsCurve& curve, const glm::dmat4& matrix) {
  return curve.with_points(transformed(curve.points(), matrix));
}

}  // namespace splinecore
