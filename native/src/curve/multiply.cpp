#include "splinecore/curve/multiply.hpp"

#include <cmath>
#include <string>

#include "basis/elevation.hpp"
#include "made_of.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

void require_positive(double value, const char* name) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InvalidShape(name + std::string(" = ") + text_of(value) + " is not a finite number above 0");
}

}  // namespace

NurbsCurve multiplied(const NurbsCurve& curve, double start, double end) {
  require_positive(start, "start");
  require_positive(end, "end");
  const NurbsCurve plain = curve.periodic() ? opened(curve, curve.domain().start) : curve;
  return applied(elevation(plain.knot_vector(), start, end), plain);
}

BezierCurve multiplied(const BezierCurve& curve, double start, double end) {
  const NurbsCurve form = multiplied(curve.nurbs(), start, end);
  return BezierCurve::make({form.points().begin(), form.points().end()});
}

}  // namespace splinecore
