#include "splinecore/curve/multiply.hpp"

#include <string>
#include <vector>

#include "base/given_points.hpp"
#include "basis/elevation.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// With factors beyond these, coordinates would lose digits or leave the range of numbers.
constexpr double kLeast = 1e-100;
constexpr double kMost = 1e100;

void require_factor(double value, const char* name) {
  if (value >= kLeast && value <= kMost) return;
  throw InvalidShape(name + std::string(" = ") + text_of(value) + " is not a number from 1e-100 to 1e100");
}

}  // namespace

NurbsCurve multiplied(const NurbsCurve& curve, double start, double end) {
  require_factor(start, "start");
  require_factor(end, "end");
  const NurbsCurve plain = curve.periodic() ? opened(curve, curve.domain().start) : curve;
  const PointMatrix matrix = elevation(plain.knot_vector(), start, end);
  std::vector<glm::dvec4> points(matrix.knots().count());
  matrix.apply(plain.homogeneous_points().data(), 1, points.data(), 1);
  constexpr bool kIsRational = true;
  return NurbsCurve::make(matrix.knots(), as_given_from(plain.points(), kIsRational, plain.weight_exponent(), points).made);
}

BezierCurve multiplied(const BezierCurve& curve, double start, double end) {
  const NurbsCurve form = multiplied(curve.nurbs(), start, end);
  return BezierCurve::make({form.points().begin(), form.points().end()});
}

}  // namespace splinecore
