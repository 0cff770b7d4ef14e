#pragma once

#include <vector>

#include "patch_approach.hpp"
#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The middles of parts of two pieces, and how large these are.
struct PatchPairSpot {
  PatchSpots middle;
  double size;
};

/// What two patches have of pairs of parts that are not known to be apart.
struct PatchPairFindings {
  std::vector<PatchPairSpot> crossing;  ///< whose normals differ, so that they meet in one line at most
  std::vector<PatchPairSpot> touching;  ///< as small as is asked, whose normals do not
};

/// @param smallest  parts of that size are not halved
/// @throws InvalidShape after too many pairs.
PatchPairFindings find_pairs(const TwoPatches& patches, double smallest, double rounding);

}  // namespace splinecore
#pragma GCC visibility pop
