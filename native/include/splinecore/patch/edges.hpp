#pragma once

#include <array>
#include <vector>

#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// How a side of a patch meets others.
enum class EdgeKind {
  free,    ///< no other side lies on the same points
  shared,  ///< two or more sides lie on the same points
  pole,    ///< all points of the side are one
  open     ///< the side is not carried by points of its own: an unclamped or periodic direction
};

/// A side of a patch; the sides are u = start, u = end, v = start, v = end.
struct PatchSide {
  EdgeKind kind = EdgeKind::open;
  /// Sides on the same points have the same edge; -1 for open sides and poles.
  int edge = -1;
  /// The side runs against the direction of its edge.
  bool reversed = false;

  friend bool operator==(const PatchSide&, const PatchSide&) = default;
};

/// For each row of the pool the first row that is equal to it: points that lie on one another.
std::vector<int> first_equal_rows(const PatchSet& set);

/// The four sides of every patch of a set.
///
/// Two sides lie on the same edge where they have equal points and weights in the same or in the
/// opposite order, on knots that are equal (to 1e-12 of the domain) after scaling to [0, 1].
std::vector<std::array<PatchSide, 4>> patch_sides(const PatchSet& set);

}  // namespace splinecore
