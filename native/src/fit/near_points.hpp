#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A row about an end of the knots: its degree + 1 functions there, or derivatives of them.
struct EndRow {
  std::vector<double> functions;
  int order;
  glm::dvec3 value;
};

/// A band matrix of functions of which every control point has one parameter near its own knots, but for rows at both
/// ends: what most interpolating curves lead to.
struct NearPoints {
  int degree;
  std::span<const double> knots;       ///< plain ones
  std::span<const double> parameters;  ///< but for those of the ends
  std::span<const glm::dvec3> points;
  std::vector<EndRow> start;
  std::vector<EndRow> end;
  double largest;  ///< coordinate of a point
};

struct NearSolution {
  std::vector<glm::dvec4> points;
  double error;  ///< the largest distance of the curve from one of the points
};

/// What distances are multiplied by so that their squares stay in the range of numbers beside those of the largest
/// coordinate.
double scale_of_distances(double largest);

/// The control points, by elimination from both ends at once, which meet in the middle: each step waits for the one
/// before it, and two wait together.
/// @returns nothing where the degree is none from 2 to 9, parameters lie elsewhere, or numbers run out of their range:
///          a general system may have a solution then.
std::optional<NearSolution> solve_near(const NearPoints& system);

}  // namespace splinecore
#pragma GCC visibility pop
