#pragma once

#include <span>
#include <vector>

#include "basis/point_matrix.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The points that a matrix makes of the curve's, on its new knots; what stays is copied bit for bit.
NurbsCurve applied(const PointMatrix& matrix, const NurbsCurve& curve);

/// The curve with the homogeneous points that a verb made of its own.
/// @param copied  of each point: which old one it is, bit for bit, or -1
NurbsCurve made_of(const NurbsCurve& curve, KnotVector knots, std::vector<glm::dvec4> points,
                   std::span<const int> copied);

}  // namespace splinecore
#pragma GCC visibility pop
