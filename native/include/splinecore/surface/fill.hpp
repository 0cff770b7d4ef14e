#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/loft.hpp"

namespace splinecore {

/// A curve that a filling ends at, or a patch that it continues at its side, with continuity 0 to 2. The strength is not used.
using FillSide = std::variant<NurbsCurve, LoftNeighbor>;

struct FillOptions {
  std::optional<double> tolerance;  ///< how far the filling may be from its sides; none: 2^-20 of their size
  double angle = 1e-4;              ///< from its neighbors' tangent planes, in radians, for which degrees rise or knots are added
};

/// What fills a hole, and how well it continues its neighbors.
struct Filling {
  std::vector<NurbsPatch> patches;     ///< one of four sides with corners; otherwise one for each corner or side, round a point
  double gap = 0.0;                    ///< the largest distance from a side
  double angle = 0.0;                  ///< the largest between tangent planes along neighbors with continuity 1 and 2
  double curvature_difference = 0.0;   ///< the largest of normal curvatures across neighbors with continuity 2
  double inner_angle = 0.0;            ///< the largest between tangent planes of patches of the filling
};

/// The surface in a hole of three to eight sides that continues its neighbors, with as few control points as come within
/// the tolerances (row S21):
/// - of four sides, from neighbors' tangent planes: the bicubic Coons patch, on whose borders the sides are what they are,
///   weights and all, of degree 3 to 7. See bicubic_coons().
/// - otherwise, and where that does not do, polynomial patches of degree 5, or 7 where curvatures are to agree, by least third
///   derivatives of what lies between them and what neighbors let expect, which is that Coons patch, or of other numbers of
///   sides a polynomial over a plane (Sarraga 1987 and Greiner 1994): eight spans at most, and shorter ones only where sides
///   need them; of four curves without neighbors the Coons patch with their weights, where those fold. Of four sides they are
///   one patch; others are split from the middle of each side to a point.
///   Where lines that run from all sides to a point, as circles would, let expect a surface that bends more evenly, as in wide and
///   deep holes, patches go by that one.
/// - where all sides follow each other without a corner: patches from each, as it is, to a point in which they all end,
///   u along the side; lines go there as circles would. Their common tangent plane there is what neighbors let expect.
/// Sides that follow each other without a corner, from neighbors, or with a slight one that stands up from their tangent
/// planes, are one side where others do not; what fills the hole
/// leaves where they meet along the line between their neighbors.
///
/// What leaves a side does so in its neighbor's tangent planes, at corners along the next side. Where neighbors do not share
/// their tangent plane, or how it turns, at a corner, nothing can continue both there: angle says how far it is off.
/// Along the line to a side's middle two patches have the knots of the sides that run beside it, and no others: where the list of
/// sides begins and which way it goes is of no matter.
///
/// @returns patches, with equal control points along their common sides; with normals on one side: on every part of every span
///          bounds of the derivatives say so, but for what lies within the tolerance of a corner; nor do they turn by a right
///          angle within the tolerance where sides do not
/// @throws InvalidShape unless there are 3 to 8 sides that close up, or where one with a neighbor turns back over it, runs
///         without a corner into one from no neighbor, or is too short beside one that it runs into; where one or two
///         corners are left, what fills the hole would fold, as it may where weights or paces along sides differ much or
///         curvatures are to continue far, and the sentence says where, a round hole is not seen whole from its middle, or continuity is not from 0 to 2;
///         ToleranceNotReached where neighboring sides' ends lie apart, or the sides are not reached
Filling fill(std::span<const FillSide> sides, const FillOptions& options = {});

}  // namespace splinecore
