#include "quintic.hpp"

namespace splinecore {

namespace {

/// The jet with derivatives of the cubic through its point that has those of `known`.
Jet completed(const Jet& jet, const Jet& known) {
  const double h = jet.u - known.u;
  const auto& [value, first, second] = known.derivatives;
  const glm::dvec3 rest = jet.derivatives[0] - (value + h * first + (0.5 * h * h) * second);
  Jet out = jet;
  out.derivatives[1] = first + h * second + (3.0 / h) * rest;
  out.derivatives[2] = second + (6.0 / h / h) * rest;
  return out;
}

/// The jet with the derivatives of the straight line to another.
Jet straightened(const Jet& jet, const Jet& other) {
  Jet out = jet;
  out.derivatives[1] = (other.derivatives[0] - jet.derivatives[0]) / (other.u - jet.u);
  out.derivatives[2] = glm::dvec3(0.0);
  return out;
}

/// The first three Bezier points of six, from the end with this jet; h is negative at the end.
std::array<glm::dvec3, 3> bezier_points(const Jet& jet, double h) {
  const auto& [value, first, second] = jet.derivatives;
  return {value, value + (0.2 * h) * first, value + (0.4 * h) * first + (0.05 * h * h) * second};
}

}  // namespace

QuinticPiece quintic_between(const Jet& start, const Jet& end) {
  if (start.is_smooth && end.is_smooth) return {start, end};
  if (start.is_smooth) return {start, completed(end, start)};
  if (end.is_smooth) return {completed(start, end), end};
  return {straightened(start, end), straightened(end, start)};
}

void evaluate(const QuinticPiece& piece, std::span<const double> parameters, std::span<glm::dvec3> out) {
  const double length = piece.interval().length();
  const auto a = bezier_points(piece.start, length);
  const auto b = bezier_points(piece.end, -length);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double t = (parameters[i] - piece.start.u) / length;
    const double s = (piece.end.u - parameters[i]) / length;
    const glm::dvec3 before = (s * s) * a[0] + (5.0 * s * t) * a[1] + (10.0 * t * t) * a[2];
    const glm::dvec3 after = (t * t) * b[0] + (5.0 * s * t) * b[1] + (10.0 * s * s) * b[2];
    out[i] = (s * s * s) * before + (t * t * t) * after;
  }
}

std::vector<double> quintic_knots(std::span<const double> joints, std::span<const char> is_smooth) {
  std::vector<double> knots(6, joints.front());
  for (std::size_t i = 1; i + 1 < joints.size(); ++i) knots.insert(knots.end(), is_smooth[i] ? 3 : 5, joints[i]);
  knots.insert(knots.end(), 6, joints.back());
  return knots;
}

std::array<double, 3> polar_weights(std::span<const double, 5> knots) {
  double sum = 0.0;
  double pairs = 0.0;
  for (const double knot : knots) {
    const double apart = knot - knots[2];
    pairs += sum * apart;
    sum += apart;
  }
  return {1.0, sum / 5.0, pairs / 20.0};
}

}  // namespace splinecore
