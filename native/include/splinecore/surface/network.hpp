#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/loft.hpp"

namespace splinecore {

/// The surface through a network of curves, each of the first ones meeting each of the others once: the sum of the
/// surfaces through either, less the one through their crossings (Gordon 1969; Lin and Hewitt 1994; row S21).
///
/// Any order and any directions; what hangs over the outermost curves is cut off. Curves along v are at the same
/// parameters on all those along u, and these on all those along v: where the given ones do not cross so, or weights at
/// crossings cannot be made one, curves are run through at another pace, as polynomials within half the tolerance.
/// Otherwise nothing is rounded. Across, a direction has the knots of the curves along it if there are as many
/// curves as these have control points, so that curves of a patch give it back; otherwise averages.
/// @param along_u    two or more; if all are closed, the surface is periodic in u, also through two or three of the others: where
///                    these leave it free it goes by the closed ones alone, half-way between
/// @param along_v    two or more, likewise
/// @param tolerance  how far curves may pass one another, and the surface lie from them; none: 2^-20 of their size
/// @param neighbours  patches from whose tangent planes, to 1e-4 radians, the surface goes on, with continuity 1, over an outermost curve that
///                    lies on their side; curves are then run through as polynomials. The strength is not used
/// @returns the surface, and the largest distance from the curves at places of them all
/// @throws InvalidShape naming the curves that do not meet once, are a point, cross in one place with another one or in another
///         order, or are fewer than four closed ones across fewer than four closed ones, or a neighbour beside none of the
///         outermost curves, or one over which a curve turns back; ToleranceNotReached, also where curves do not leave a
///         neighbour in its tangent planes.
Approximation<NurbsPatch> network(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v,
                                  std::optional<double> tolerance = {},
                                  std::span<const LoftNeighbour> neighbours = {});

}  // namespace splinecore
