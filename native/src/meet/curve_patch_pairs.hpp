#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curve_pieces.hpp"
#include "patch_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a curve, and one of a patch.
struct PierceSpot {
  CurveSpot curve;
  PatchSpot patch;
};

struct CurveAndPatch {
  const CurvePieces& curve;
  const PatchPieces& patch;

  double distance(const PierceSpot& at) const;
};

/// A stretch of a piece of a curve that lies on a patch, up to the tolerance, and a place of the patch beside its middle.
struct CurveOnPatch {
  std::size_t piece;
  Interval range;
  PatchSpot patch;
};

struct PiercePairFindings {
  std::vector<PierceSpot> crossings;    ///< not in order, some more than once
  std::vector<CurveOnPatch> stretches;  ///< not in order, neighbors apart
};

/// The place that Newton's method finds from there, of pieces that go on beyond their ends. @returns none if it finds none
std::optional<PierceSpot> pierced(const CurveAndPatch& shapes, PierceSpot at);

/// @throws InvalidShape after too many pairs.
PiercePairFindings find_pairs(const CurveAndPatch& shapes, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
