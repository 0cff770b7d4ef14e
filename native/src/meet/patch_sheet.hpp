#pragma once

#include <glm/vec3.hpp>

#include "patch_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether a patch goes from one of two places beside a point to the other without leaving the point by more than a
/// distance, over its seams and poles, too; not where it crosses itself.
bool are_on_one_sheet(const PatchPieces& patch, const PatchSpot& one, const PatchSpot& other, const glm::dvec3& point,
                      double distance);

}  // namespace splinecore
#pragma GCC visibility pop
