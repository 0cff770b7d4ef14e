#pragma once

#include <vector>

#include "splinecore/patch/patch_set.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Some patches seen from the other side, as flipped() has all of them.
/// @param which  of each patch whether it is; @throws InvalidShape if there are not as many
PatchSet flipped(const PatchSet& set, const std::vector<bool>& which);

}  // namespace splinecore
#pragma GCC visibility pop
