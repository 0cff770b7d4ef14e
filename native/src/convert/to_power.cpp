#include "splinecore/convert/to_power.hpp"

#include <cmath>

#include "basis/power.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/convert/to_bezier.hpp"

namespace splinecore {

namespace {

PowerCurve power_on(const BezierCurve& curve, Interval range, double origin) {
  std::vector<glm::dvec4> rows = bernstein_to_power(curve.nurbs().homogeneous_points(), range, origin);
  const int exponent = curve.nurbs().weight_exponent();
  for (glm::dvec4& row : rows) {
    for (int axis = 0; exponent != 0 && axis < 4; ++axis) row[axis] = std::scalbn(row[axis], exponent);
  }
  return PowerCurve::make(std::move(rows), origin, range);
}

}  // namespace

PowerCurve to_power(const BezierCurve& curve, double origin) { return power_on(curve, {0.0, 1.0}, origin); }

std::vector<PowerCurve> to_power(const NurbsCurve& curve) {
  std::vector<PowerCurve> powers;
  for (const BezierCurve& bezier : to_bezier(curve)) {
    const Interval range = curve.knot_vector().span_interval(static_cast<int>(powers.size()));
    powers.push_back(power_on(bezier, range, range.start));
  }
  return powers;
}

}  // namespace splinecore
