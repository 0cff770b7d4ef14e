#include "splinecore/build/parametrisation.hpp"

#include <cmath>

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

}  // namespace

std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parametrisation kind, Closing closing) {
  require_finite(points, "points");
  if (points.empty()) return {};
  const std::size_t count = points.size() + (closing == Closing::closed ? 1 : 0);
  std::vector<double> parameters(count);
  for (std::size_t i = 1; i < count; ++i) {
    const glm::dvec3& point = points[i < points.size() ? i : 0];
    const double next = parameters[i - 1] + step(points[i - 1], point, kind);
    if (!std::isfinite(next)) {
      throw InvalidShape("points" + index_text(i % points.size()) + " is too far from points" + index_text(i - 1) +
                         ": their distance overflows");
    }
    if (!(next > parameters[i - 1])) {
      throw InvalidShape("points" + index_text(i % points.size()) + " is too close to points" + index_text(i - 1) +
                         ": their distance is no step of the parameter");
    }
    parameters[i] = next;
  }
  return parameters;
}

}  // namespace splinecore
