#pragma once

#include <vector>

#include "splinecore/patch/patch_set.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patches of a set, which must outlive them.
std::vector<const NurbsPatch*> patches_of(const PatchSet& set);

/// @throws InvalidShape unless the patches close up and their normals agree.
void require_closed(const PatchSet& set);

}  // namespace splinecore
#pragma GCC visibility pop
