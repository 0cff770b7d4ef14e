#include "bezier_runs.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "splinecore/build/join.hpp"

namespace splinecore {

glm::dvec3 start_of(const BezierCurve& curve) { return glm::dvec3(curve.points().front()); }
glm::dvec3 end_of(const BezierCurve& curve) { return glm::dvec3(curve.points().back()); }

BezierCurve bezier_line(const glm::dvec3& a, const glm::dvec3& b) {
  return BezierCurve::make({glm::dvec4(a, 1.0), glm::dvec4(b, 1.0)});
}

double length_of(const BezierCurve& curve) {
  double length = 0.0;
  const auto points = curve.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].w == 0.0 || points[i - 1].w == 0.0) continue;
    length += glm::distance(glm::dvec3(points[i]), glm::dvec3(points[i - 1]));
  }
  return length;
}

NurbsCurve curve_of(const BezierPieces& pieces) {
  std::vector<double> parameters{0.0};
  for (const BezierCurve& piece : pieces) {
    parameters.push_back(parameters.back() + std::max(length_of(piece), kSamePlace));
  }
  constexpr double kGap = 0x1p-24;
  return join_beziers(pieces, std::move(parameters), kGap);
}

}  // namespace splinecore
