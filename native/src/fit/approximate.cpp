#include "splinecore/fit/approximate.hpp"

#include <algorithm>
#include <string>

#include "conditions.hpp"
#include "control_counts.hpp"
#include "fitted_points.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// So many places from the first parameter to the last, with as many parameters between each two.
std::vector<double> even_places(std::span<const double> parameters, std::size_t count) {
  std::vector<double> places;
  const double step = static_cast<double>(parameters.size() - 1) / static_cast<double>(count - 1);
  for (std::size_t j = 0; j + 1 < count; ++j) {
    const double place = static_cast<double>(j) * step;
    const auto i = std::min(static_cast<std::size_t>(place), parameters.size() - 2);
    const double share = place - static_cast<double>(i);
    places.push_back(parameters[i] + share * (parameters[i + 1] - parameters[i]));
  }
  places.push_back(parameters.back());
  return places;
}

/// As of a curve that interpolates at such places: each control point then has parameters near the middle of its
/// function, which decide about it however few they are.
KnotVector averaged_knots(std::span<const double> parameters, std::size_t points, int degree, std::size_t count,
                          Closing closing) {
  const bool is_closed = closing == Closing::closed;
  InterpolationOptions options;
  options.degree = degree;
  options.closing = closing;
  const bool is_each = count == points;
  const std::vector<double> around = is_each ? std::vector<double>(parameters.begin(), parameters.end())
                                             : even_places(parameters, count + (is_closed ? 1 : 0));
  KnotVector knots = knots_for(std::span(around).first(count), around, options);
  if (!is_closed || knots.domain().start == parameters.front()) return knots;
  // Half-way between places, of even degrees: the period begins at the first parameter all the same.
  std::vector<double> moved(knots.knots().begin(), knots.knots().end());
  moved.front() = parameters.front();
  moved.back() = parameters.back();
  return KnotVector::make(degree, std::move(moved), true);
}

KnotVector even_share_knots(std::span<const double> parameters, std::size_t points, int degree, std::size_t spans,
                            Closing closing) {
  const bool is_closed = closing == Closing::closed;
  const double step = static_cast<double>(points) / static_cast<double>(spans);
  const std::size_t copies = is_closed ? 1 : static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(copies, parameters.front());
  for (std::size_t j = 1; j < spans; ++j) {
    const double place = static_cast<double>(j) * step;
    const auto i = std::min(static_cast<std::size_t>(place), points - 1);
    const double share = place - static_cast<double>(i);
    knots.push_back(parameters[i - 1] + share * (parameters[i] - parameters[i - 1]));
  }
  knots.insert(knots.end(), copies, parameters.back());
  return KnotVector::make(degree, std::move(knots), is_closed);
}

}  // namespace

KnotVector approximating_knots(std::span<const double> parameters, int degree, std::size_t count, Closing closing) {
  const bool is_closed = closing == Closing::closed;
  const std::size_t points = parameters.size() - (is_closed && !parameters.empty() ? 1 : 0);
  require_enough_points(points, degree, is_closed);
  require_count(count, degree, is_closed);
  if (count > points) {
    throw InvalidShape("count = " + std::to_string(count) + " control points are more than the " +
                       std::to_string(points) + " points");
  }
  const std::size_t spans = is_closed ? count : count - static_cast<std::size_t>(degree);
  const std::size_t enough = static_cast<std::size_t>(degree) + 1;
  if (points < enough * spans) return averaged_knots(parameters, points, degree, count, closing);
  return even_share_knots(parameters, points, degree, spans, closing);
}

namespace {

Approximation<NurbsCurve> approximated(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                       const KnotVector& knots, const ApproximationOptions& options) {
  const std::span<const double> at = parameters.first(points.size());
  if (options.corrections == 0) {
    const FittedPoints made = fitted_points(points, at, knots, options);
    return {made.curve(), made.error};
  }
  std::vector<double> moved(at.begin(), at.end());
  const FittedPoints made = corrected_fit(points, moved, knots, options);
  return {made.curve(), made.error};
}

}  // namespace

Approximation<NurbsCurve> approximate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const KnotVector& knots, const ApproximationOptions& options) {
  require_approximation(points, parameters, knots.periodic() ? Closing::closed : Closing::open, options);
  return approximated(points, parameters, knots, options);
}

Approximation<NurbsCurve> approximate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      int degree, std::size_t count, Closing closing,
                                      const ApproximationOptions& options) {
  require_approximation(points, parameters, closing, options);
  return approximated(points, parameters, approximating_knots(parameters, degree, count, closing), options);
}

}  // namespace splinecore
