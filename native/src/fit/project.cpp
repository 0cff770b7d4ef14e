#include "splinecore/fit/project.hpp"

#include <algorithm>
#include <cmath>

#include "base/length.hpp"
#include "fitted_points.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec3> values_of(const CurveFunction& function, std::span<const double> parameters) {
  std::vector<glm::dvec3> values(parameters.size());
  function(parameters, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::dvec3& value = values[i];
    if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) continue;
    throw InvalidShape("the function is not finite at " + text_of(parameters[i]));
  }
  return values;
}

std::vector<double> even_parameters(std::span<const double> breaks) {
  constexpr int kEach = 64;
  std::vector<double> parameters;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    for (int k = 0; k < kEach; ++k) {
      parameters.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * (static_cast<double>(k) / kEach));
    }
  }
  parameters.push_back(breaks.back());
  return parameters;
}

}  // namespace

Approximation<NurbsCurve> project(const CurveFunction& function, const KnotVector& knots, bool fixed_ends) {
  constexpr int kFewestNodes = 16;
  const std::vector<double> breaks = breaks_of(knots, knots);
  const bool holds_ends = fixed_ends && !knots.periodic();
  QuadratureNodes nodes = quadrature_nodes(breaks, std::max(kFewestNodes, knots.degree() + 8), holds_ends);
  const std::vector<glm::dvec3> values = values_of(function, nodes.parameters);
  ApproximationOptions options;
  options.weights = nodes.weights;
  options.fixed_ends = holds_ends;
  const FittedPoints fit = fitted_points(values, nodes.parameters, knots, options);
  NurbsCurve curve = fit.curve();
  const std::vector<double> even = even_parameters(breaks);
  const std::vector<glm::dvec3> wanted = values_of(function, even);
  std::vector<glm::dvec3> found(even.size());
  evaluate(curve, even, {&found.front().x, 3 * found.size()});
  double error = fit.error;
  for (std::size_t i = 0; i < found.size(); ++i) error = std::max(error, distance_of(found[i], wanted[i]));
  return {std::move(curve), error};
}

}  // namespace splinecore
