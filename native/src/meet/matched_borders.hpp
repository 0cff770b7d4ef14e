#pragma once

#include "patch_match.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The sides of what matches beyond which one of both patches does not go on; those that are points are left out.
std::vector<SectionTrace> matched_borders(const TwoPatches& patches, const std::array<AxisMatch, 2>& axes,
                                          const std::array<std::vector<MatchedSpan>, 2>& spans, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
