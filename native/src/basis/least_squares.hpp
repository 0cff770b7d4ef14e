#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "point_matrix.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The old points that a matrix brings nearest to given new points, in the sum of squares.
///
/// Conjugate gradients on the normal equations (CGLS, Björck 1996, §7.4), restarted until rounding is all
/// that is left: the matrices of knots and degrees are well-conditioned at the degrees of modeling.
/// @param start  where to begin; the points named by `fixed` stay there
std::vector<glm::dvec4> closest_preimage(const PointMatrix& matrix, std::span<const glm::dvec4> points,
                                         std::vector<glm::dvec4> start, std::span<const int> fixed);

}  // namespace splinecore
#pragma GCC visibility pop
