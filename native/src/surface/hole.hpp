#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hole_side.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A hole; its sides know how to leave them.
struct Hole {
  std::vector<HoleSide> sides;
  double share;  ///< of each side beside a corner, in the patch that has this corner

  /// The highest one of a side, at least 1.
  int continuity() const {
    int most = 1;
    for (const HoleSide& side : sides) most = std::max(most, side.continuity());
    return most;
  }

  std::size_t before(std::size_t i) const { return (i + sides.size() - 1) % sides.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % sides.size(); }
};

/// Of pieces that go round it. Those that go on into each other without a corner, from neighbors, are one side; but where none
/// or fewer than three sides would be left, each is one.
Hole hole_of(const std::vector<SidePiece>& pieces);

/// Whether a side goes on into the next one without a corner: within a degree or so, at which patches with one would fold.
bool goes_on_at_end(const Hole& hole, std::size_t i);

class HoleGuide;

/// Sets how sides leave: at a corner along the next side, and so that both of a corner agree on mixed derivatives there, as
/// nearly as their neighbors let them and as none leaves back over its neighbor.
/// @param guide  to what they leave for between corners, if any
/// @throws InvalidShape where one does at a corner, or a side with a neighbor goes on into another without a corner
void agree_at_corners(Hole& hole, const HoleGuide* guide);

}  // namespace splinecore
#pragma GCC visibility pop
