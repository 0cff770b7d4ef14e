#pragma once

#include <cstddef>
#include <vector>

#include "adaptive_pieces.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Volume; first moments; second moments xx, xy, xz, yy, yz, zz.
inline constexpr std::size_t kMoments = 10;
using MomentValues = Integrals<kMoments>;
using MomentSums = IntegralSums<kMoments>;
using FoundMoments = FoundIntegrals<kMoments>;

/// What each moment may be off by, given those found so far.
using MomentTargets = AdaptivePieces<kMoments>::Targets;

/// The moments about the origin of what closed patches enclose.
/// @throws InvalidShape where weights or sizes differ too much, as a sentence that begins with what.
FoundMoments moments_of(const std::vector<NurbsPatch>& patches, const MomentTargets& targets, const char* what);

}  // namespace splinecore
#pragma GCC visibility pop
