#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Places so near, in a space where the curve is about 1 large, are one.
inline constexpr double kSamePlace = 0x1p-40;

/// Pieces that follow each other.
using BezierPieces = std::vector<BezierCurve>;

glm::dvec3 start_of(const BezierCurve& curve);
glm::dvec3 end_of(const BezierCurve& curve);
BezierCurve bezier_line(const glm::dvec3& a, const glm::dvec3& b);

/// How long the polygon of a piece is.
double length_of(const BezierCurve& curve);

/// A curve piece after piece, each as long in its parameter as its polygon is.
NurbsCurve curve_of(const BezierPieces& pieces);

}  // namespace splinecore
#pragma GCC visibility pop
