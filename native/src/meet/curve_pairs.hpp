#pragma once

#include <vector>

#include "curve_approach.hpp"
#include "curve_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parts of two pieces that lie together within the tolerance.
struct CurveStretch {
  std::size_t piece_a;
  Interval a;
  std::size_t piece_b;
  Interval b;
  int way;          ///< whether the second one goes on as the first one does, 1, or back, -1; 0 where they are points
  bool is_trivial;  ///< where a curve goes on from one part to the other
};

/// What two curves, or one with itself, have of places where they are within a tolerance of each other.
struct PairFindings {
  std::vector<SpotPair> crossings;      ///< not in order, some more than once
  std::vector<CurveStretch> stretches;  ///< not in order, neighbors apart
};

PairFindings find_pairs(const CurvePieces& a, const CurvePieces& b, double tolerance);

/// Of different places of one curve, the first parameter the smaller one.
PairFindings find_own_pairs(const CurvePieces& curve, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
