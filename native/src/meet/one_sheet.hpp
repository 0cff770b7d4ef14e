#pragma once

#include <array>

#include "patch_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether no two places of a range of parameters, which may go on over the seam of a closed patch, are one point: seen along
/// some direction derivatives along u are nowhere parallel to such along v, so that no sum of both is zero.
/// @returns false where that is not known
bool is_one_sheet(const PatchPieces& patch, const std::array<Interval, 2>& range);

}  // namespace splinecore
#pragma GCC visibility pop
