#include "splinecore/curve/transform.hpp"

#include <glm/vec3.hpp>
#include <string>

#include "affine.hpp"
#include "base/given_points.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

bool is_affine(const glm::dmat4& matrix) noexcept {
  return matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
}

std::vector<glm::dvec4> transformed(std::span<const glm::dvec4> given, const glm::dmat4& matrix) {
  const bool is_rational = splinecore::is_rational(given);
  const int exponent = is_rational && !is_affine(matrix) ? weight_exponent(given) : 0;
  std::vector<glm::dvec4> points(given.begin(), given.end());
  if (is_affine(matrix)) {
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

BezierCurve transformed(const BezierCurve& curve, const glm::dmat4& matrix) {
  return curve.with_points(transformed(curve.points(), matrix));
}

PowerCurve transformed(const PowerCurve& curve, const glm::dmat4& matrix) {
  std::vector<glm::dvec4> coefficients;
  for (const glm::dvec4& given : curve.coefficients()) coefficients.push_back(matrix * given);
  return PowerCurve::make(std::move(coefficients), curve.origin(), curve.domain());
}

void require_affine(const glm::dmat4& matrix, const char* what) {
  if (!is_affine(matrix)) {
    throw InvalidShape(std::string("the map is not affine: the image of a Hermite ") + what + " is none; take to_nurbs()");
  }
}

HermiteCurve transformed(const HermiteCurve& curve, const glm::dmat4& matrix) {
  require_affine(matrix, "curve");
  const glm::dmat3 linear(matrix);
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& point : curve.points()) points.push_back(glm::dvec3(matrix * glm::dvec4(point, 1.0)));
  std::vector<Tangents> tangents(curve.tangents().begin(), curve.tangents().end());
  for (Tangents& at : tangents) at = {linear * at.incoming, linear * at.outgoing};
  return HermiteCurve::make(std::move(points), std::move(tangents),
                            {curve.parameters().begin(), curve.parameters().end()});
}

}  // namespace splinecore
