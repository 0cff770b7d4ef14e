#pragma once

#include <array>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// How a side of a panel meets others.
struct PanelSide {
  int edge = -1;          ///< sides that are one curve have one edge; -1 where the side is a point: a pole
  bool reversed = false;  ///< it runs against its edge
  friend bool operator==(const PanelSide&, const PanelSide&) = default;
};

/// A part of a patch without gaps inside; its sides are u = start, u = end, v = start, v = end.
struct Panel {
  std::size_t patch = 0;
  Interval u;
  Interval v;
  std::array<PanelSide, 4> sides;
  friend bool operator==(const Panel&, const Panel&) = default;
};

/// Sides nearer to one another than this, as a part of the extent of the larger of their two patches, are one curve.
inline constexpr double kOneCurve = 1e-10;

/// The panels of a set, patch by patch: where it is connected, and where it has an end.
///
/// Two sides are one edge where they are one curve at equal parameters, scaled to [0, 1], in one direction or
/// the other, whatever their degrees, knots and points: a rational curve of degree p and one of degree q are
/// compared at p + q + 1 places between every two knots of either, however near these are, where they may differ by
/// kOneCurve. Knots of the two that are equal but for rounding are one. So the sides of a closed direction are one
/// edge, too.
std::vector<Panel> panels_of(const PatchSet& set);

/// How many sides each edge has.
std::vector<int> side_counts(const std::vector<Panel>& panels);

/// A side of a patch that is one edge with a side of a patch.
struct SharedEdge {
  std::size_t first_patch;
  Border first;
  std::size_t second_patch;
  Border second;
  bool reversed;  ///< the second runs against the first
};

/// Where whole sides of patches are one, by patches and sides; of more than two on an edge each one with the next.
std::vector<SharedEdge> shared_edges(const PatchSet& set);

}  // namespace splinecore
