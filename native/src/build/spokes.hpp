#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "splinecore/build/sweeps.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where a control point goes as it turns: foot + x out + y across on a circle of (x, y). Of a direction (weight
/// 0) the foot is its part along the axis.
struct Spoke {
  glm::dvec3 foot;
  glm::dvec3 out;
  glm::dvec3 across;
  double weight;
};

/// The patch of spokes, which are the control points of a profile on its knots, that turn.
/// @throws InvalidShape for a sweep that is zero or more than a whole turn.
NurbsPatch turned(const KnotVector& profile, const std::vector<Spoke>& spokes, const Turn& turn);

/// A closed curve of degree 2 whose ends are one point, as a periodic one with double knots.
NurbsCurve closed_ring(const NurbsCurve& curve);

/// The length of a vector. @throws InvalidShape naming it if it has none or is not finite.
double require_length(const glm::dvec3& vector, const std::string& argument);

/// @throws InvalidShape naming the argument if a coordinate is not finite.
void require_place(const glm::dvec3& place, const std::string& argument);

}  // namespace splinecore
#pragma GCC visibility pop
