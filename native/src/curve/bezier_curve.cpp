#include "splinecore/curve/bezier_curve.hpp"

#include <algorithm>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

BezierCurve BezierCurve::make(std::vector<glm::dvec4> points) {
  if (points.size() < 2) {
    throw InvalidShape("points has " + std::to_string(points.size()) +
                       " rows, a Bezier curve needs 2 or more");
  }
  const int degree = static_cast<int>(std::min<std::size_t>(points.size() - 1, kMaxDegree + 1));
  return BezierCurve(NurbsCurve::make(KnotVector::bezier(degree),
                                      std::move(points)));
}

BezierCurve BezierCurve::from_homogeneous(std::span<const glm::dvec4> points) {
  return make(as_given(points));
}

std::pair<BezierCurve, BezierCurve> split(const BezierCurve& curve, double u) {
  const auto [left, right] = split(curve.nurbs(), u);
  return {BezierCurve::make({left.points().begin(), left.points().end()}),
          BezierCurve::make({right.points().begin(), right.points().end()})};
}

BezierCurve reversed(const BezierCurve& curve) {
  return BezierCurve::make({curve.points().rbegin(), curve.points().rend()});
}

}  // namespace splinecore
