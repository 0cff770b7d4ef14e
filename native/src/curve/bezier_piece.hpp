#pragma once

#include "basis/bernstein_net.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The homogeneous Bezier points of the piece on one of the spans of the knot vector.
inline BernsteinNet<glm::dvec4> bezier_piece(const NurbsCurve& curve, int span) {
  return bezier_piece(curve.knot_vector(), span, curve.homogeneous_points().data());
}

}  // namespace splinecore
#pragma GCC visibility pop
