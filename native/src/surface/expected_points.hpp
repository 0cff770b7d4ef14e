#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hole.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "star.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What the surface round a hole lets expect inside, as control points of a star.
///
/// Of four sides it is the bicubic patch that leaves them as their neighbors do (Coons 1967). Of others heights over a plane,
/// along its normal: those of the polynomial of degree 4 that is nearest to the sides and to the slopes of their neighbors.
/// @param patches  of the star, which leave the sides so, and where there are several, say where over the plane its points are
/// @returns none for a hole without neighbors, and for one that is no graph over a plane
std::vector<glm::dvec3> expected_points(const Hole& hole, const Star& star, std::span<const NurbsPatch> patches);

}  // namespace splinecore
#pragma GCC visibility pop
