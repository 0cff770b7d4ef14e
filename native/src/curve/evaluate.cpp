#include "splinecore/curve/evaluate.hpp"

#include <limits>

#include "span_cursor.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Calls visit(i, u, homogeneous point) for every parameter.
template <class Visit>
void for_each_point(const NurbsCurve& curve, std::span<const double> parameters, Side side, Visit visit) {
  SpanCursor cursor(curve, parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double u = curve.knot_vector().admit(parameters[i], side, i);
    visit(i, u, cursor.at(u, side));
  }
}

template <class Real>
void evaluate_into(const NurbsCurve& curve, std::span<const double> parameters, std::span<Real> out,
                   EvaluateOptions options) {
  for_each_point(curve, parameters, options.side, [&](std::size_t i, double u, const glm::dvec4& h) {
    glm::dvec3 point = curve.rational() ? project(h) : glm::dvec3(h);
    if (!is_finite(point)) {
      if (options.at_infinity == AtInfinity::raise) throw PointAtInfinity(u);
      point = glm::dvec3(kNan);
    }
    for (int axis = 0; axis < 3; ++axis) out[3 * i + axis] = static_cast<Real>(point[axis]);
  });
}

}  // namespace

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<double> out,
              EvaluateOptions options) {
  evaluate_into(curve, parameters, out, options);
}

void evaluate(const NurbsCurve& curve, std::span<const double> parameters, std::span<float> out,
              EvaluateOptions options) {
  evaluate_into(curve, parameters, out, options);
}

void derivatives(const NurbsCurve& curve, std::span<const double> parameters, int order,
                 std::span<double> out, EvaluateOptions options) {
  require_order(order);
  const glm::dvec4* points = curve.homogeneous_points().data();
  std::vector<glm::dvec4> homogeneous(order + 1);
  std::vector<glm::dvec3> values(order + 1);
  Stencil at(curve.knot_vector(), order);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double u = curve.knot_vector().admit(parameters[i], options.side, i);
    at.move_to(u, options.side);
    for (int k = 0; k <= order; ++k) {
      homogeneous[k] = weighted_sum(at.weights(k), points + at.first());
    }
    if (curve.rational()) {
      quotient_derivatives(homogeneous, values);
    } else {
      for (int k = 0; k <= order; ++k) values[k] = glm::dvec3(homogeneous[k]);
    }
    for (int k = 0; k <= order; ++k) {
      if (!is_finite(values[k])) {
        if (options.at_infinity == AtInfinity::raise) throw PointAtInfinity(u);
        values[k] = glm::dvec3(kNan);
      }
      for (int axis = 0; axis < 3; ++axis) out[3 * (i * (order + 1) + k) + axis] = values[k][axis];
    }
  }
}

void evaluate_homogeneous(const NurbsCurve& curve, std::span<const double> parameters,
                          std::span<glm::dvec4> out, Side side) {
  for_each_point(curve, parameters, side, [&](std::size_t i, double, const glm::dvec4& h) { out[i] = h; });
}

}  // namespace splinecore
