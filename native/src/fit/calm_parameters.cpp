#include <cmath>

#include "base/length.hpp"
#include "calm_steps.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/fit/interpolate.hpp"

namespace splinecore {

namespace {

double length_around(std::span<const glm::dvec3> points, Closing closing) {
  double length = closing == Closing::closed ? distance_of(points.back(), points.front()) : 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance_of(points[i - 1], points[i]);
  return length;
}

/// Of the steps.
std::vector<double> with_roots(std::vector<double> parameters) {
  double before = 0.0;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const double step = std::sqrt(parameters[i] - before);
    before = parameters[i];
    parameters[i] = parameters[i - 1] + step;
  }
  return parameters;
}

}  // namespace

std::vector<double> ending_at(std::vector<double> parameters, double length) {
  if (parameters.empty() || !(length > 0.0) || !std::isfinite(length)) return parameters;
  const double whole = parameters.back();
  for (double& parameter : parameters) parameter = length * (parameter / whole);
  return parameters;
}

std::vector<double> calm_parameters(std::span<const glm::dvec3> points, int degree, Closing closing) {
  const int roots = calm_roots(degree);
  const auto kind = roots == kNoRoots ? Parameterization::uniform : Parameterization::centripetal;
  std::vector<double> parameters = parameters_of(points, kind, closing);
  if (points.size() < 2) return parameters;
  for (int root = 1; root < roots; ++root) parameters = with_roots(std::move(parameters));
  return ending_at(std::move(parameters), length_around(points, closing));
}

}  // namespace splinecore
