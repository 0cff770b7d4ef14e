#pragma once

#include <optional>

#include "shared_edges.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A border that lies on the other patch, cut at corners and where the patches touch and part to the other side from there on.
/// Along pieces of it where they touch it is no crossing, and left out. @returns none where it nowhere crosses plainly
std::optional<SharedEdges> cut_at_turns(const TwoPatches& patches, const SectionTrace& whole, const PatchContact& contact,
                                        double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
