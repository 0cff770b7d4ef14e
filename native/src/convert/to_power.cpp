#include "splinecore/convert/to_power.hpp"

#include "splinecore/basis/power.hpp"
#include "splinecore/convert/to_bezier.hpp"

namespace splinecore {

namespace {

PowerCurve power_on(const BezierCurve& curve, Interval range, double origin) {
  return PowerCurve::make(bernstein_to_power(curve.nurbs().homogeneous_points(), range, origin), origin, range);
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
