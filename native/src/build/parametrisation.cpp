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

/// Chord lengths summed up, or nothing where one of them needs a second look.
bool write_plain_chords(std::span<const glm::dvec3> points, std::vector<double>& parameters) {
  double sum = 0.0;
  bool are_plain = true;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec3 chord = points[i] - points[i - 1];
    const double square = chord.x * chord.x + chord.y * chord.y + chord.z * chord.z;
    const double next = sum + std::sqrt(square);
    are_plain &= is_plain_square(square) & (next > sum);
    parameters[i] = sum = next;
  }
  return are_plain;
}

}  // namespace

std::vector<double> parameters_of(std::span<const glm::dvec3> points, Parametrisation kind, Closing closing) {
  require_finite(points, "points");
  if (points.empty()) return {};
  const std::size_t count = points.size() + (closing == Closing::closed ? 1 : 0);
  std::vector<double> parameters(count);
  const bool is_plain = kind == Parametrisation::chordal && closing == Closing::open;
  if (is_plain && write_plain_chords(points, parameters)) return parameters;
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
