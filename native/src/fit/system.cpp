#include "system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/require.hpp"
#include "basis/blossom.hpp"
#include "curve/rescale.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

Side side_at(const KnotVector& knots, double parameter) {
  return !knots.periodic() && parameter == knots.domain().end ? Side::left : Side::right;
}

/// A point of the curve has a control point of its own (Schoenberg and Whitney 1953).
void require_own_function(const KnotVector& knots, const Condition& condition, std::size_t i, std::ptrdiff_t first,
                          std::span<const double> weights) {
  if (knots.periodic() || condition.order > 0) return;
  const std::ptrdiff_t own = static_cast<std::ptrdiff_t>(i) - first;
  if (own >= 0 && own < std::ssize(weights) && weights[static_cast<std::size_t>(own)] > 0.0) return;
  throw InvalidShape("parameters" + index_text(condition.point) + " = " + text_of(condition.parameter) +
                     ": no curve with these knots passes through all points, for too many lie between some of them");
}

}  // namespace

System system_of(const KnotVector& knots, std::span<const Condition> conditions) {
  const auto order = std::ranges::max_element(conditions, {}, &Condition::order)->order;
  const auto [exponent, near] = near_one(knots);
  Stencil derivatives(near, order);
  const auto width = static_cast<std::size_t>(knots.degree()) + 1;
  const std::size_t count = conditions.size();
  System system{{width, std::vector<std::ptrdiff_t>(count), std::vector<double>(count * width)},
                std::vector<double>(3 * count)};
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

void solve(const KnotVector& knots, const BandedRows& rows, std::span<double> right, std::size_t columns) {
  knots.periodic() ? solve_cyclic(rows, right, columns) : solve_banded(rows, right, columns);
}

void require_passing(double error, double largest) {
  constexpr double kRounding = 1e-6;
  if (error <= kRounding * largest) return;
  throw InvalidShape("rounding leaves the shape " + text_of(error) +
                     " from where it should be: the conditions hardly determine it, or its degree is too high for them");
}

double largest_coordinate(std::span<const glm::dvec3> points) {
  const double largest = points.empty() ? 0.0 : kernels().largest_size(&points.front().x, 3 * points.size());
  if (!std::isfinite(largest)) require_finite(points, "points");
  return largest;
}

void refuse_control_point() { throw InvalidShape("the control points are too large for numbers"); }

}  // namespace splinecore
