#include "splinecore/build/parametrisation.hpp"

#include <cmath>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

double step(const glm::dvec3& from, const glm::dvec3& to, Parametrisation kind) {
  if (kind == Parametrisation::uniform) return 1.0;
  const double distance = std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
  return kind == Parametrisation::chordal ? distance : std::sqrt(distance);
}

}  // namespace

std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parametrisation kind, Closing closing) {
  require_finite(points, "points");
  std::vector<double> parameters;
  if (points.empty()) return parameters;
  parameters.push_back(0.0);
  const std::size_t count = points.size() + (closing == Closing::closed ? 1 : 0);
  for (std::size_t i = 1; i < count; ++i) {
    const double next = parameters.back() + step(points[i - 1], points[i % points.size()], kind);
    if (!std::isfinite(next)) {
      throw InvalidShape("points" + index_text(i % points.size()) + " is too far from points" + index_text(i - 1) +
                         ": their distance overflows");
    }
    if (!(next > parameters.back())) {
      throw InvalidShape("points" + index_text(i % points.size()) + " is too close to points" + index_text(i - 1) +
                         ": their distance is no step of the parameter");
    }
    parameters.push_back(next);
  }
  return parameters;
}

}  // namespace splinecore
