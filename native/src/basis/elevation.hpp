#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "point_matrix.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The same functions as functions of one degree more: every distinct knot has one copy more.
///
/// Outer knots that nothing depends on any more are left out. Each new point is the mean of degree + 1
/// points of refined curves, so its weights are convex (Ramshaw 1989, ch. 7: the blossom of degree
/// p + 1 is the mean of that of degree p over all choices of its arguments; lecture row S15).
/// @throws InvalidShape if the degree would exceed kMaxDegree.
PointMatrix elevation(const KnotVector& knots);

/// elevation(), and the functions times the linear function that is `start` at the start of the domain and `end` at its end:
/// the blossom of a product is the mean of the products of blossoms. Weights may be any numbers.
PointMatrix elevation(const KnotVector& knots, double start, double end);

/// What elevation() makes of points on a plain vector, so many times, without its matrices.
struct ElevatedPoints {
  KnotVector knots;
  std::vector<glm::dvec4> points;
  std::vector<int> copied;  ///< of each point: which old one it is, or -1
};
ElevatedPoints elevated(const KnotVector& knots, std::span<const glm::dvec4> points, int times);

}  // namespace splinecore
#pragma GCC visibility pop
