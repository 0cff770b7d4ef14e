#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A point with the first two derivatives by the parameter u.
struct Jet {
  double u = 0.0;
  std::array<glm::dvec3, 3> derivatives{};
  /// False where the derivatives do not exist.
  bool is_smooth = false;
};

/// The quintic with two derivatives given at both ends (Hermite; lecture row S4).
struct QuinticPiece {
  Jet start;
  Jet end;

  Interval interval() const noexcept { return {start.u, end.u}; }
};

/// Where an end has no derivatives it gets those of the cubic that the rest determines; where both have
/// none, those of the straight line.
QuinticPiece quintic_between(const Jet& start, const Jet& end);

/// The points at parameters of the interval.
void evaluate(const QuinticPiece& piece, std::span<const double> parameters, std::span<glm::dvec3> out);

/// Knots of degree 5: sixfold at the ends, threefold at joints with two derivatives, fivefold elsewhere.
std::vector<double> quintic_knots(std::span<const double> joints, std::span<const char> is_smooth);

/// How the derivatives 0, 1, 2 at the middle knot add up to the control point of five knots, three of which
/// are that knot: its polar value (Ramshaw 1989).
std::array<double, 3> polar_weights(std::span<const double, 5> knots);

}  // namespace splinecore
#pragma GCC visibility pop
