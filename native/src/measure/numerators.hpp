#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A polynomial over [0, 1] in Bernstein's form, and how much of a coefficient may be rounding.
struct Numerator {
  std::vector<double> coefficients;
  double noise = 0.0;
};

/// The numerator A' W - A W' of the derivative of A / W; A' where every W is 1.
/// @param line  Bernstein points (A, W) of a degree above 0
Numerator slope_of(std::span<const glm::dvec2> line);

/// The numerator of the signed curvature of a plane curve: x' y'' - x'' y' where every W is 1, otherwise
/// det(P, P', P'') of the homogeneous points, whose sign is that of the curvature where W is positive.
/// @param points  Bernstein points (X, Y, W) of a degree above 0
Numerator bend_of(std::span<const glm::dvec3> points);

/// X Y' - X' Y: twice the area that the line from the origin sweeps, where W is 1; over W² it is that where it is not.
/// @param points  Bernstein points (X, Y) of a degree above 0
Numerator sweep_of(std::span<const glm::dvec2> points);

}  // namespace splinecore
#pragma GCC visibility pop
