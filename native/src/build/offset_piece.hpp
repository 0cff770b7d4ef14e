#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How a curve is moved: to the left of its tangent, seen against a unit normal.
struct SideStep {
  glm::dvec3 normal;
  double distance;
  double tolerance;
};

/// A place of a curve, the unit tangent there, and its offset with the derivative by the parameter.
struct OffsetPlace {
  glm::dvec3 point;
  glm::dvec3 tangent;
  glm::dvec3 moved;
  glm::dvec3 slope;
  double stretch;  ///< by how much the offset is longer than the curve; below zero it runs back
};

OffsetPlace offset_place(const BezierCurve& curve, double t, const SideStep& step);

/// The offset of a piece as pieces that follow each other: none if it is a point.
/// @throws InvalidShape if the piece does not come within the tolerance.
std::vector<BezierCurve> offset_piece(const BezierCurve& curve, const SideStep& step);

}  // namespace splinecore
#pragma GCC visibility pop
