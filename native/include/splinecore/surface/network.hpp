#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/loft.hpp"

namespace splinecore {

/// The surface through a network, and what was found of it.
struct NetworkSurface {
  NurbsPatch value;
  double error = 0.0;  ///< the largest distance from the curves at places of them all
  /// How far its sides u_start, u_end, v_start, v_end are from the outermost curves at the same share of their parameters; where that is 0
  /// but for rounding, what has such a curve as its edge and the surface are one seam. None where a direction is closed.
  std::array<std::optional<double>, 4> paces;
};

/// The surface through a network of curves, each of the first ones meeting each of the others once: the sum of the
/// surfaces through either, less the one through their crossings (Gordon 1969; Lin and Hewitt 1994; row S21).
///
/// Any order and any directions; what hangs over the outermost curves by more than the gap is cut off. Curves along v are at
/// the same parameters on all those along u, and these on all those along v. Outermost curves keep their pace and their weights, but
/// for a factor that is the same everywhere or linear, so that edges of other patches stay edges: the others are run through at
/// their pace, and with weights between theirs, within half the tolerance where they do not cross so. Where both outermost ones
/// of a direction are at different paces that of the one given first is kept, and paces say how far the other is off. A
/// direction that is closed begins where the outermost curve does that keeps its pace.
/// Across, a direction has the knots of the curves along it if there are as many
/// curves as these have control points, so that curves of a patch give it back; otherwise averages.
/// @param along_u    two or more; if all are closed, the surface is periodic in u, also through two or three of the others: where
///                    these leave it free it goes by the closed ones alone, half-way between
/// @param along_v    two or more, likewise
/// @param tolerance  how far the surface may lie from the curves; none: 2^-20 of their size
/// @param gap         how far curves may pass one another; none: the tolerance. With a gap the surface may lie farther from them
///                    by up to 8 times the largest distance at which two do
/// @param neighbors  patches from whose tangent planes, to 1e-4 radians, the surface continues, with continuity 1, over an outermost curve that
///                    lies on their side; rational curves are then run through as polynomials. The strength is not used
/// @throws InvalidShape naming the curves that do not meet once, are a point, cross in one place with another one or in another
///         order, or are fewer than four closed ones across fewer than four closed ones, or a neighbor beside none of the
///         outermost curves, or one over which a curve turns back, or whose tangent planes turn so sharply along its side that
///         4096 spans do not follow them; ToleranceNotReached, also where curves do not leave a neighbor in its tangent planes.
NetworkSurface network(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v,
                       std::optional<double> tolerance = {}, std::span<const LoftNeighbor> neighbors = {},
                       std::optional<double> gap = {});

}  // namespace splinecore
