#pragma once

#include <vector>

#include "patch_march.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Borders of one of two patches that lie on the other one, where they do not go on in each other.
struct SharedEdges {
  std::vector<SectionTrace> traces;  ///< they end at corners and where the patches touch
  std::vector<SectionTouch> turns;   ///< where patches touch, and from where on they part to the other side
};

/// Borders that lie on the other patch up to rounding: along them a foot tells what a crossing, at a small angle, does not.
SharedEdges shared_edges(const TwoPatches& patches, double tolerance, double rounding);

}  // namespace splinecore
#pragma GCC visibility pop
