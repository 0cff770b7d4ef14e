#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws PointAtInfinity with parameters near which the weight of the patch is zero.
void require_finite_points(const NurbsPatch& patch);

}  // namespace splinecore
#pragma GCC visibility pop
