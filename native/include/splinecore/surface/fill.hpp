#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/loft.hpp"

namespace splinecore {

/// A curve that a filling ends at, or a patch from whose side it goes on, with continuity 0 to 2. The strength is not used.
using FillSide = std::variant<NurbsCurve, LoftNeighbour>;

struct FillOptions {
  std::optional<double> tolerance;  ///< how far the filling may be from its sides; none: 2^-20 of their size
  double angle = 1e-4;              ///< from its neighbours' tangent planes, in radians: it has more knots until that is so
};

/// What fills a hole, and how well it goes on.
struct Filling {
  std::vector<NurbsPatch> patches;     ///< one of four sides; otherwise one for each corner, round a point
  double gap = 0.0;                    ///< the largest distance from a side
  double angle = 0.0;                  ///< the largest between tangent planes along neighbours with continuity 1 and 2
  double curvature_difference = 0.0;   ///< the largest of normal curvatures across neighbours with continuity 2
  double inner_angle = 0.0;            ///< the largest between tangent planes of patches of the filling
};

/// The surface in a hole of three to eight sides that goes on from its neighbours, by least third derivatives of what lies between
/// it and the one that these let expect (of four sides the bicubic Coons patch, of others a polynomial over a plane): patches of
/// degree 5, or 7 where curvatures are to agree, with as few knots as come within the tolerances, eight spans at most (row S21;
/// Sarraga 1987 and Greiner 1994).
///
/// A hole of four sides is one patch; others are split from the middle of each side to a point. What leaves a side does so in
/// its neighbour's tangent planes, at corners along the next side. Where neighbours do not share their tangent plane, or how it
/// turns, at a corner, nothing can go on from both there: angle says how far it is off.
/// @returns patches, with equal control points along their common sides, with normals on one side
/// @throws InvalidShape unless there are 3 to 8 sides that go round, or where one with a neighbour turns back over it or runs
///         on into the next side without a corner, or continuity is not from 0 to 2; ToleranceNotReached where neighbouring sides' ends lie apart, or the sides are not
///         reached.
Filling fill(std::span<const FillSide> sides, const FillOptions& options = {});

}  // namespace splinecore
