#pragma once

#include <functional>
#include <vector>

#include "patch_approach.hpp"
#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of pairs of parts that are not known to be apart the middles.
struct PatchPairFindings {
  std::vector<PatchSpots> crossing;  ///< whose normals differ, so that they meet in one line at most
  std::vector<PatchSpots> touching;  ///< as small as is asked, whose normals do not
};

/// Whether all that two parts may have in common is known.
using IsPairKnown = std::function<bool(const PatchPart&, const PatchPart&)>;

/// @param smallest  parts of that size are not halved
/// @param is_known  asked of parts whose normals do not differ
/// @throws InvalidShape after too many pairs.
PatchPairFindings find_pairs(const TwoPatches& patches, double smallest, double rounding, const IsPairKnown& is_known);

}  // namespace splinecore
#pragma GCC visibility pop
