#include "splinecore/build/parametrisation.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "base/distance.hpp"
#include "base/require.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

double step(const glm::dvec3& from, const glm::dvec3& to, Parametrisation kind) {
  if (kind == Parametrisation::uniform) return 1.0;
  const double distance = distance_of(from, to);
  return kind == Parametrisation::chordal ? distance : std::sqrt(distance);
}

[[noreturn]] void refuse_step(const std::vector<double>& parameters, std::size_t count) {
  std::size_t i = 1;
  while (parameters[i] > parameters[i - 1] && std::isfinite(parameters[i])) ++i;
  const std::string place = "points" + index_text(i % count);
  const std::string before = " points" + index_text(i - 1);
  if (!std::isfinite(parameters[i])) throw InvalidShape(place + " is too far from" + before + ": their distance overflows");
  throw InvalidShape(place + " is too close to" + before + ": their distance is no step of the parameter");
}

}  // namespace

std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parametrisation kind, Closing closing) {
  require_finite(points, "points");
  if (points.empty()) return {};
  const std::size_t count = points.size() + (closing == Closing::closed ? 1 : 0);
  std::vector<double> parameters(count);
  bool are_steps = true;
  for (std::size_t i = 1; i < count; ++i) {
    const glm::dvec3& point = points[i < points.size() ? i : 0];
    parameters[i] = parameters[i - 1] + step(points[i - 1], point, kind);
    are_steps &= parameters[i] > parameters[i - 1] && parameters[i] <= std::numeric_limits<double>::max();
  }
  if (!are_steps) refuse_step(parameters, points.size());
  return parameters;
}

}  // namespace splinecore
