#pragma once

#include <string>
#include <vector>

#include "splinecore/patch/panels.hpp"
#include "splinecore/patch/patch_set.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patches of a set, which must outlive them.
std::vector<const NurbsPatch*> patches_of(const PatchSet& set);

/// "the side u = start of patches[3]"
std::string side_name(std::size_t patch, int side);

/// 1 where the boundary of a patch, with its inside to the left, runs along a side in the direction of its edge, else -1.
int turn_of(int side, const PanelSide& found);

/// @throws InvalidShape unless the patches close up and their normals agree.
void require_closed(const PatchSet& set);

}  // namespace splinecore
#pragma GCC visibility pop
