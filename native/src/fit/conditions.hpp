#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/fit/interpolate.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a curve has to be at one parameter: its derivative of this order, 0 for the point.
struct Condition {
  double parameter;
  int order;
  glm::dvec3 value;
  std::size_t point;  ///< that it belongs to
};

/// All conditions in the order of their parameters, so that each can decide about a control point of its own.
/// @throws InvalidShape as interpolate() does.
std::vector<Condition> conditions_of(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                     const InterpolationOptions& options);

/// The knots for them: those given, or chosen.
/// @throws InvalidShape if the knots given are as many as other points need.
KnotVector knots_for(std::span<const Condition> conditions, std::span<const double> parameters,
                     const InterpolationOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
