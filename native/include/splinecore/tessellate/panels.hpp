#pragma once

#include <array>
#include <vector>

#include "splinecore/patch/patch_set.hpp"
#include "splinecore/tessellate/cells.hpp"

namespace splinecore {

/// How a side of a panel meets others.
struct PanelSide {
  int edge = -1;          ///< sides that are one curve have one edge; -1 where the side is a point
  bool reversed = false;  ///< it runs against its edge
};

/// A part of a patch without gaps inside; its sides are u start, u end, v start, v end.
struct Panel {
  std::size_t patch = 0;
  Cell whole;
  std::array<PanelSide, 4> sides;
};

/// The panels of a set.
///
/// Two sides are one edge where they are one curve at equal parameters, scaled to [0, 1], in one direction or
/// the other, whatever their degrees and knots: a rational curve of degree p and one of degree q are compared at
/// p + q + 1 places between every two knots of either, where they differ by no more than the tolerance (a length).
std::vector<Panel> panels_of(const PatchSet& set, double tolerance);

}  // namespace splinecore
