#include "splinecore/fit/project.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/length.hpp"
#include "base/sort_by.hpp"
#include "fitted_points.hpp"
#include "function_breaks.hpp"
#include "project_smooth.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

std::vector<double> with_even_parameters(std::vector<double> parameters, std::span<const double> breaks) {
  constexpr int kEach = 64;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    for (int k = 0; k < kEach; ++k) {
      parameters.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * (static_cast<double>(k) / kEach));
    }
  }
  parameters.push_back(breaks.back());
  std::ranges::sort(parameters);
  const auto repeated = std::ranges::unique(parameters);
  parameters.erase(repeated.begin(), repeated.end());
  return parameters;
}

std::vector<double> distances(const NurbsCurve& curve, const CurveFunction& function,
                              std::span<const double> parameters) {
  const std::vector<glm::dvec3> wanted = values_of(function, parameters);
  std::vector<glm::dvec3> found(parameters.size());
  evaluate(curve, parameters, {&found.front().x, 3 * found.size()});
  std::vector<double> out;
  for (std::size_t i = 0; i < found.size(); ++i) out.push_back(distance_of(found[i], wanted[i]));
  return out;
}

/// Places around the largest of the distances that are no less than their neighbors.
std::vector<double> around_tops(std::span<const double> distances, std::span<const double> parameters) {
  constexpr double kNear = 0.75;
  constexpr std::size_t kMostTops = 64;
  constexpr int kBetween = 8;
  const std::size_t last = distances.size() - 1;
  const double least = kNear * *std::ranges::max_element(distances);
  std::vector<std::size_t> tops;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool is_top = (i == 0 || distances[i] >= distances[i - 1]) && (i == last || distances[i] >= distances[i + 1]);
    if (is_top && distances[i] > least) tops.push_back(i);
  }
  sort_by(tops, [&](std::size_t i) { return -distances[i]; });
  tops.resize(std::min(tops.size(), kMostTops));
  std::vector<double> places;
  for (const std::size_t i : tops) {
    const double low = parameters[i > 0 ? i - 1 : 0];
    const double high = parameters[std::min(i + 1, last)];
    for (int k = 0; k <= kBetween; ++k) places.push_back(low + (high - low) * k / kBetween);
  }
  std::ranges::sort(places);
  return places;
}

/// The largest at the parameters, and uphill from those.
double largest_distance(const NurbsCurve& curve, const CurveFunction& function, std::vector<double> parameters) {
  constexpr int kRounds = 20;
  double largest = 0.0;
  for (int round = 0; round < kRounds && !parameters.empty(); ++round) {
    const std::vector<double> found = distances(curve, function, parameters);
    largest = std::max(largest, *std::ranges::max_element(found));
    parameters = around_tops(found, parameters);
  }
  return largest;
}

/// The spans of the knots, and parts of them that the integrals are told by.
struct Breaks {
  std::vector<double> spans;
  std::vector<double> parts;
};

Approximation<NurbsCurve> projected(const CurveFunction& function, const KnotVector& knots, bool holds_ends, int count,
                                    const Breaks& breaks) {
  QuadratureNodes nodes = quadrature_nodes(breaks.parts, count, holds_ends);
  const std::vector<glm::dvec3> values = values_of(function, nodes.parameters);
  ApproximationOptions options;
  options.weights = nodes.weights;
  options.fixed_ends = holds_ends;
  NurbsCurve curve = fitted_points(values, nodes.parameters, knots, options).curve();
  std::vector<double> looked_at = nodes.parameters;
  looked_at.insert(looked_at.end(), breaks.parts.begin(), breaks.parts.end());
  const double error = largest_distance(curve, function, with_even_parameters(std::move(looked_at), breaks.spans));
  return {std::move(curve), error};
}

}  // namespace

Approximation<NurbsCurve> project(const CurveFunction& function, const KnotVector& knots, bool fixed_ends) {
  constexpr int kFewestNodes = 16;
  const int count = std::max(kFewestNodes, knots.degree() + 8);
  const std::vector<double> spans = breaks_of(knots, knots);
  const Breaks breaks{spans, function_breaks(function, spans, count)};
  return projected(function, knots, fixed_ends && !knots.periodic(), count, breaks);
}

Approximation<NurbsCurve> project_smooth(const CurveFunction& function, const KnotVector& knots, bool fixed_ends) {
  const std::vector<double> spans = breaks_of(knots, knots);
  return projected(function, knots, fixed_ends && !knots.periodic(), knots.degree() + 8, {spans, spans});
}

}  // namespace splinecore
