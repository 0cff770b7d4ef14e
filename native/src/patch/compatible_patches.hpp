#pragma once

#include <span>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Patches over the domains of the first, of the same degrees and on the same knots in both directions, as compatible()
/// makes curves: the same surfaces.
/// @throws InvalidShape as compatible() of curves
std::vector<NurbsPatch> compatible(std::span<const NurbsPatch> patches);

}  // namespace splinecore
#pragma GCC visibility pop
