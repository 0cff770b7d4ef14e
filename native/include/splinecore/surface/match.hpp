#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

struct MatchOptions {
  int continuity = 1;              ///< 0: the side, 1: tangent planes, 2: curvatures, 3: how these change
  int rows = 0;                    ///< of control points from the side on that may move; 0: as few as it takes
  double strength = 1.0;           ///< how far the patch follows the other one: its speed by that with which it moves least
  std::optional<bool> is_reversed; ///< it runs against the other one; none: run_against() says
};

/// A patch whose side is that of another one, and which continues it there (row S21; Farin 2002 on composite
/// surfaces).
///
/// Along the side both get, exactly, one degree and the same knots. Of the rows of control points beside the side the
/// first ones follow from the other patch's derivatives: they continue as L(t) A(k t + m t² / 2 + n t³ / 6), as
/// joined_patches() makes them, by k, m and n with which row after row moves least (least squares); at the patch's own pace,
/// or a lower one, where weights would not stay positive, or from curvatures on points would lie off the straight ways out by
/// more than 1.5 times these, or than they do. Of those that may move, too, the others go with them so that the differences of what they move by are as
/// even as can be. The rest stay where they are: the patch is raised in degree until the opposite side is among these.
/// @returns the patch over its domain, and the largest distance by which a point of it moved, at equal parameters
/// @throws InvalidShape if the continuity is not from 0 to 3, or rows are too few for it, the strength is not above 0, a
///         derivative of the patch across its side is zero, that is the seam of a periodic direction, or lies at infinity;
///         ToleranceNotReached where rounding leaves it off the other one's tangent planes by more than 1e-4 radians, or off its
///         curvatures by more than a thousandth of the largest.
Approximation<NurbsPatch> matched(const NurbsPatch& patch, Border side, const NurbsPatch& onto, Border onto_side,
                                  const MatchOptions& options = {});

}  // namespace splinecore
