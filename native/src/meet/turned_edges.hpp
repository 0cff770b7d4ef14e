#pragma once

#include <optional>

#include "shared_edges.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A border that lies on the other patch, cut at corners and where the patches touch and part to the other side from there on.
/// @returns none where they touch along a part of it, so that it is no crossing
std::optional<SharedEdges> cut_at_turns(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact,
                                        double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
