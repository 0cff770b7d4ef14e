#pragma once

#include "patch_match.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How parameters of two patches may match: whole to whole, either way round, and where places of one are on the other.
std::vector<std::array<AxisMatch, 2>> axis_matches(const TwoPatches& patches, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
