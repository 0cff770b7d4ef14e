#pragma once

#include <vector>

#include "curve_cluster.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Stretches of both curves as places, and the clusters that say what of one is beside what of the other.
struct LaidOverlap {
  Interval a;
  Interval b;
  bool is_reversed;
  std::vector<const CurveCluster*> clusters = {};

  LaidOverlap swapped() const { return {b, a, is_reversed, {}}; }
};

/// Overlaps go on over what turns back by up to so many tolerances, as long as curves stay beside each other.
inline constexpr double kTurnsBack = 16.0;
/// And they are two only where they are farther apart along one of the curves than so many.
inline constexpr double kOwn = 64.0;
/// A place that is no farther from one along both, and from where curves stay within so many tolerances, is of it.
inline constexpr double kOfOverlap = 4.0;

/// Those that are left of overlaps that go on in one another, or are beside longer ones, however they were found.
std::vector<LaidOverlap> own_overlaps(std::vector<LaidOverlap> overlaps, const TwoCurves& curves, double tolerance);

/// Whether a place is of one of the overlaps.
bool is_of_any(const std::vector<LaidOverlap>& overlaps, const SpotPair& at, const TwoCurves& curves, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
