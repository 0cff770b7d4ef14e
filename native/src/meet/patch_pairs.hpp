#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "crossing_part.hpp"
#include "patch_approach.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A crossing part without its nets.
struct CrossingRanges {
  std::size_t piece_a;
  std::array<Interval, 2> a;
  std::size_t piece_b;
  std::array<Interval, 2> b;
  std::array<int, 4> signs;
  std::size_t lead;

  CrossingPart of(const TwoPatches& patches) const {
    return {part_of(piece_a, patches.a.piece(piece_a), a), part_of(piece_b, patches.b.piece(piece_b), b), signs, lead};
  }
};

/// Pairs of parts that are not known to be apart.
struct PatchPairFindings {
  std::vector<CrossingRanges> crossing;
  std::vector<PatchSpots> touching;  ///< of those as small as is asked, whose normals do not differ, the middles
};

/// Whether all that two parts may have in common is known.
using IsPairKnown = std::function<bool(const PatchPart&, const PatchPart&)>;

/// How far pairs of parts are told apart.
struct PairLimits {
  double smallest;     ///< parts of that size are not halved
  double rounding;     ///< parts so near may have places in common
  double tolerance;    ///< surfaces that nowhere part by more are one
  std::string gap_of_copies;  ///< by how much they part where they are such, for the sentence of a refusal
};

/// @param is_matched  asked of all pairs that are not apart
/// @param is_known  asked of parts whose normals do not differ
/// @throws InvalidShape after too many pairs.
PatchPairFindings find_pairs(const TwoPatches& patches, const PairLimits& limits, const IsPairKnown& is_matched,
                             const IsPairKnown& is_known);

}  // namespace splinecore
#pragma GCC visibility pop
