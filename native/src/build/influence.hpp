#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What the control points of one axis count at a parameter: in the value there, and in its first two derivatives.
struct Influence {
  /// @throws InvalidShape if u is outside the domain.
  static Influence at(const KnotVector& knots, double u, const char* name = "u");

  std::vector<double> value;
  std::vector<double> slope;
  std::vector<double> bend;
};

/// The same of points with weights; those at infinity count nothing, as they stay.
/// @param plain  of the same points without weights; derivatives only where it has any
/// @return false where the weight is zero, up to rounding
bool make_rational(Influence& plain, std::span<const glm::dvec4> points);

/// What points and derivatives count of a Hermite chain with these parameters.
struct HermiteInfluence {
  static HermiteInfluence at(std::span<const double> parameters, double u, const char* name = "u");

  Influence points;
  Influence incoming;
  Influence outgoing;
  /// A third of the span before and after each point; at the ends that of the other side.
  std::vector<double> before;
  std::vector<double> after;
};

}  // namespace splinecore
#pragma GCC visibility pop
