#include "fitted_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/require.hpp"
#include "conditions.hpp"
#include "control_counts.hpp"
#include "curve/rescale.hpp"
#include "least_squares_fit.hpp"
#include "least_squares_options.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

void require_derivatives(std::span<const glm::dvec3> derivatives, const KnotVector& knots, bool is_fixed) {
  if (derivatives.empty()) return;
  if (!is_fixed) throw InvalidShape("derivatives are for the fixed ends of an open curve");
  if (derivatives.size() < static_cast<std::size_t>(knots.degree())) return;
  throw InvalidShape(std::to_string(derivatives.size()) + " derivatives at an end are too many for degree " +
                     std::to_string(knots.degree()) + ", which has room for " + std::to_string(knots.degree() - 1));
}

/// An end that is fixed is at a control point.
void require_clamped(const KnotVector& knots) {
  const auto chain = knots.knots();
  const auto degree = static_cast<std::size_t>(knots.degree());
  if (chain[0] == chain[degree] && chain[chain.size() - 1] == chain[chain.size() - 1 - degree]) return;
  throw InvalidShape("knots: a curve that begins and ends at given points has its first and last knot " +
                     std::to_string(degree + 1) + " times");
}

void require_inside(const KnotVector& knots, std::span<const double> parameters) {
  const Interval domain = knots.domain();
  if (parameters.front() >= domain.start && parameters.back() <= domain.end) return;
  throw InvalidShape("parameters from " + text_of(parameters.front()) + " to " + text_of(parameters.back()) +
                     " leave the knots' domain from " + text_of(domain.start) + " to " + text_of(domain.end));
}

/// Writes the control points that a fixed end and its derivatives decide, one after the other: those of
/// order k depend on k + 1 of them.
void write_end(const KnotVector& knots, const glm::dvec3& point, std::span<const glm::dvec3> derivatives, bool is_end,
               std::vector<glm::dvec3>& controls) {
  const auto [exponent, near] = near_one(knots);
  const std::size_t count = derivatives.size();
  const std::size_t last = controls.size() - 1;
  const auto at = [&](std::size_t k) -> glm::dvec3& { return controls[is_end ? last - k : k]; };
  at(0) = point;
  if (count == 0) return;
  Stencil stencil(near, static_cast<int>(count));
  stencil.move_to(is_end ? near.domain().end : near.domain().start, is_end ? Side::left : Side::right);
  for (std::size_t k = 1; k <= count; ++k) {
    const auto weights = stencil.weights(static_cast<int>(k));
    const auto weight = [&](std::size_t j) { return weights[is_end ? weights.size() - 1 - j : j]; };
    glm::dvec3 left(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      left[axis] = std::ldexp(derivatives[k - 1][axis], static_cast<int>(k) * exponent);
    }
    for (std::size_t j = 0; j < k; ++j) left -= weight(j) * (at(j) - point);
    at(k) = point + left / weight(k);
  }
}

std::span<const double> numbers(std::span<const glm::dvec3> points) { return {&points.front().x, 3 * points.size()}; }
std::span<double> numbers(std::vector<glm::dvec3>& points) { return {&points.front().x, 3 * points.size()}; }

/// Moves each parameter towards the foot of its point, by one step of Newton's method, and by less than half the way to
/// its neighbors, so that their order stays (Hoschek 1988). The ends of an open curve stay.
void correct(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::vector<double>& parameters) {
  constexpr double kMostOfGap = 0.45;
  const std::size_t count = parameters.size();
  std::vector<double> values(9 * count);
  derivatives(curve, parameters, 2, values);
  const auto before = parameters;
  const bool is_closed = curve.periodic();
  for (std::size_t i = is_closed ? 0 : 1; i + (is_closed ? 0 : 1) < count; ++i) {
    const double* const at = &values[9 * i];
    const glm::dvec3 left = points[i] - glm::dvec3(at[0], at[1], at[2]);
    const glm::dvec3 slope(at[3], at[4], at[5]);
    const glm::dvec3 bend(at[6], at[7], at[8]);
    const double square = glm::dot(slope, slope);
    const double curved = square - glm::dot(left, bend);
    // Where the distance has no minimum nearby, the step along the tangent.
    const double step = glm::dot(left, slope) / (curved > 0.0 ? std::max(curved, 0.25 * square) : square);
    if (!std::isfinite(step)) continue;
    const Interval domain = curve.domain();
    const double back = before[i] - (i > 0 ? before[i - 1] : domain.start);
    const double ahead = (i + 1 < count ? before[i + 1] : domain.end) - before[i];
    parameters[i] = before[i] + std::clamp(step, -kMostOfGap * back, kMostOfGap * ahead);
  }
}

FittedPoints fitted_once(std::span<const glm::dvec3> points, std::span<const double> parameters, const KnotVector& knots,
                         const ApproximationOptions& options) {
  const bool is_fixed = options.fixed_ends && !knots.periodic();
  const Held held = is_fixed ? Held{1 + options.start.size(), 1 + options.end.size()} : Held{};
  const auto count = static_cast<std::size_t>(knots.count());
  require_room_for_ends(count, held.start + held.end);
  std::vector<glm::dvec3> controls(count, points.front());
  if (is_fixed) {
    write_end(knots, points.front(), options.start, false, controls);
    write_end(knots, points.back(), options.end, true, controls);
  }
  const LeastSquaresFit fit(knots, parameters, options.weights, options.smoothing, held);
  std::vector<double> span_errors = fit.solve_points(numbers(points), numbers(controls));
  FittedPoints made{knots, std::move(controls), std::move(span_errors), 0.0};
  made.error = *std::ranges::max_element(made.span_errors);
  return made;
}

}  // namespace

NurbsCurve FittedPoints::curve() const {
  std::vector<glm::dvec4> points;
  points.reserve(controls.size());
  for (const glm::dvec3& point : controls) {
    require_control_point(point);
    points.emplace_back(point, 1.0);
  }
  return NurbsCurve::make(knots, std::move(points));
}

void require_approximation(std::span<const glm::dvec3> points, std::span<const double> parameters, Closing closing,
                           const ApproximationOptions& options) {
  const std::size_t least = closing == Closing::closed ? 3 : 2;
  if (points.size() < least) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, at least " + std::to_string(least) +
                       " are needed");
  }
  require_finite(points, "points");
  require_parameters(parameters, points.size() + (closing == Closing::closed ? 1 : 0));
  require_weights(options.weights, points.size());
  require_finite(options.start, "start");
  require_finite(options.end, "end");
  require_smoothing(options.smoothing);
  require_corrections(options.corrections);
}

void require_approximation_knots(const KnotVector& knots, std::span<const double> parameters,
                                 const ApproximationOptions& options) {
  const bool is_fixed = options.fixed_ends && !knots.periodic();
  require_derivatives(options.start, knots, is_fixed);
  require_derivatives(options.end, knots, is_fixed);
  if (is_fixed) require_clamped(knots);
  if (options.smoothing > 0.0 && knots.degree() < 2) throw InvalidShape("smoothing needs degree 2 at least");
  require_inside(knots, parameters);
}

FittedPoints fitted_points(std::span<const glm::dvec3> points, std::span<const double> parameters,
                           const KnotVector& knots, const ApproximationOptions& options) {
  require_approximation_knots(knots, parameters, options);
  return fitted_once(points, parameters, knots, options);
}

FittedPoints corrected_fit(std::span<const glm::dvec3> points, std::vector<double>& parameters, const KnotVector& knots,
                           const ApproximationOptions& options) {
  FittedPoints made = fitted_points(points, parameters, knots, options);
  for (int i = 0; i < options.corrections; ++i) {
    std::vector<double> moved = parameters;
    correct(made.curve(), points, moved);
    FittedPoints next = fitted_once(points, moved, knots, options);
    if (!(next.error < made.error)) break;
    parameters = std::move(moved);
    made = std::move(next);
  }
  return made;
}

}  // namespace splinecore
