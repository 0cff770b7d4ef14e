#pragma once

#include <optional>

#include "height_difference.hpp"
#include "matched_nets.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Two parts that lie along each other, compared place by place: far larger ones are told apart so than by bounds of each,
/// as what both do alike is taken off exactly. It holds for parts that are nearly copies of each other, however wild both
/// are.
struct MatchedParts {
  bool are_beside = false;      ///< whether they have no place in common, as those of one end before those of the other
  RangesOfTwo of_a;                     ///< what of each may have places in common with the other, of their pieces
  RangesOfTwo of_b;
  HeightDifference difference;  ///< of these, as far as known
};

/// @returns none where they are no polynomials with lines that run along each other
std::optional<MatchedParts> matched_parts(const PatchPart& a, const PatchPart& b, double rounding);

}  // namespace splinecore
#pragma GCC visibility pop
