#pragma once

#include "basis/bernstein_net.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The homogeneous Bezier points of the piece on one of the spans of each knot vector.
inline BernsteinNet<glm::dvec4> bezier_piece(const NurbsPatch& patch, int span_u, int span_v) {
  return bezier_piece(patch.knot_vector(Axis::u), span_u, patch.knot_vector(Axis::v), span_v,
                      patch.homogeneous_points().data());
}

}  // namespace splinecore
#pragma GCC visibility pop
