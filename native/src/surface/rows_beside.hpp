#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Rows of control points from a side on, of a patch with clamped knots.
/// @param inwards  the knots across the side, from it on
/// @param across   for orders 0, 1, … of derivatives across, into the patch, their values at interpolation_places() along the side
std::vector<std::vector<glm::dvec3>> rows_beside(const KnotVector& knots, const KnotVector& inwards,
                                                 const std::vector<std::vector<glm::dvec3>>& across);

}  // namespace splinecore
#pragma GCC visibility pop
