#include "splinecore/fit/interpolate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/quotient.hpp"
#include "basis/banded.hpp"
#include "basis/blossom.hpp"
#include "conditions.hpp"
#include "curve/rescale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// Rows of functions for the conditions, and their right sides. Rows of derivatives are divided by their largest number.
struct System {
  BandedRows rows;
  std::vector<double> right;
};

Side side_at(const KnotVector& knots, double parameter) {
  return !knots.periodic() && parameter == knots.domain().end ? Side::left : Side::right;
}

/// A point of the curve has a control point of its own (Schoenberg and Whitney 1953).
void require_own_function(const KnotVector& knots, const Condition& condition, std::size_t i, long first,
                          std::span<const double> weights) {
  if (knots.periodic() || condition.order > 0) return;
  const long own = static_cast<long>(i) - first;
  if (own >= 0 && own < static_cast<long>(weights.size()) && weights[static_cast<std::size_t>(own)] > 0.0) return;
  throw InvalidShape("parameters" + index_text(condition.point) + " = " + text_of(condition.parameter) +
                     ": no curve with these knots passes through all points, for too many lie between some of them");
}

System system_of(const KnotVector& knots, std::span<const Condition> conditions) {
  const auto order = std::ranges::max_element(conditions, {}, &Condition::order)->order;
  const auto [exponent, near] = near_one(knots);
  Stencil derivatives(near, order);
  const auto width = static_cast<std::size_t>(knots.degree()) + 1;
  const std::size_t count = conditions.size();
  System system{{width, std::vector<long>(count), std::vector<double>(count * width)}, std::vector<double>(3 * count)};
  std::vector<double> arguments(width - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Condition& condition = conditions[i];
    const Side side = side_at(knots, condition.parameter);
    const double u = std::ldexp(knots.admit(condition.parameter, side, condition.point, "parameters"), -exponent);
    const std::span<double> row = system.rows.row(i);
    if (condition.order == 0) {
      const int start = near.spans()[static_cast<std::size_t>(near.span_of(u, side))];
      system.rows.first[i] = start - knots.degree();
      std::ranges::fill(arguments, u);
      breathe(4 * width * width);
      blossom_weights(near.unrolled().data() + system.rows.first[i], knots.degree(), arguments, row.data());
    } else {
      if (i == 0 || conditions[i - 1].order == 0 || conditions[i - 1].point != condition.point) {
        derivatives.move_to(u, side);
      }
      system.rows.first[i] = derivatives.first();
      std::ranges::copy(derivatives.weights(condition.order), row.begin());
    }
    require_own_function(knots, condition, i, system.rows.first[i], row);
    double largest = condition.order == 0 ? 1.0 : 0.0;
    for (const double weight : row) largest = std::max(largest, std::abs(weight));
    if (condition.order > 0) std::ranges::for_each(row, [&](double& weight) { weight /= largest; });
    for (int axis = 0; axis < 3; ++axis) {
      system.right[3 * i + axis] = std::ldexp(condition.value[axis], condition.order * exponent) / largest;
    }
  }
  return system;
}

/// The control points.
std::vector<glm::dvec4> solved(const KnotVector& knots, const System& system) {
  const std::size_t count = system.rows.count();
  std::vector<double> right = system.right;
  knots.periodic() ? solve_cyclic(system.rows, right, 3) : solve_banded(system.rows, right, 3);
  std::vector<glm::dvec4> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = right.data() + 3 * i;
    points[i] = {row[0], row[1], row[2], 1.0};
    if (!is_finite(glm::dvec3(points[i]))) {
      throw InvalidShape("the control points of the curve are too large for numbers");
    }
  }
  return points;
}

/// Of the curve from its points.
double largest_distance(const NurbsCurve& curve, const BandedRows& rows, std::span<const Condition> conditions) {
  const std::span<const glm::dvec4> points = curve.points();
  double largest = 0.0;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].order > 0) continue;
    breathe(4 * rows.width);
    const auto row = rows.row(i);
    glm::dvec3 left = conditions[i].value;
    std::size_t at = static_cast<std::size_t>(rows.first[i]) % points.size();
    for (const double weight : row) {
      left -= weight * glm::dvec3(points[at]);
      if (++at == points.size()) at = 0;
    }
    largest = std::max(largest, std::hypot(left.x, left.y, left.z));
  }
  return largest;
}

/// A system that hardly decides the points leaves them to rounding.
void require_passing(double error, std::span<const Condition> conditions) {
  constexpr double kRounding = 1e-6;
  double largest = 0.0;
  for (const Condition& condition : conditions) {
    if (condition.order > 0) continue;
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(condition.value[axis]));
  }
  if (error <= kRounding * largest) return;
  throw InvalidShape("rounding leaves the curve " + text_of(error) +
                     " from its points: the conditions hardly determine it, or its degree is too high for them");
}

}  // namespace

Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const InterpolationOptions& options) {
  const std::vector<Condition> conditions = conditions_of(points, parameters, options);
  const KnotVector knots = knots_for(conditions, parameters, options);
  const System system = system_of(knots, conditions);
  NurbsCurve curve = NurbsCurve::make(knots, solved(knots, system));
  const double error = largest_distance(curve, system.rows, conditions);
  require_passing(error, conditions);
  return {std::move(curve), error};
}

}  // namespace splinecore
