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

/// @throws InvalidShape unless they are so many, increase, and their distances are finite.
void require_parameters(std::span<const double> parameters, std::size_t count);

/// @throws InvalidShape as interpolate() does where so many points, parameters or options cannot be.
void require_interpolation(std::size_t count, std::span<const double> parameters,
                           const InterpolationOptions& options);

/// All conditions in the order of their parameters, so that each can decide about a control point of its own.
/// @throws InvalidShape if they are fewer than the degree needs.
std::vector<Condition> conditions_of(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                     const InterpolationOptions& options);

/// The knots for conditions at these sites, that is parameters, in order: those given, or chosen.
/// @throws InvalidShape if the knots given are as many as other points need.
KnotVector knots_for(std::span<const double> sites, std::span<const double> parameters,
                     const InterpolationOptions& options);

std::vector<double> sites_of(std::span<const Condition> conditions);

}  // namespace splinecore
#pragma GCC visibility pop
