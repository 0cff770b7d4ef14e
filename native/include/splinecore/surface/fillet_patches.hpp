#pragma once

#include <optional>
#include <span>

#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/sweep.hpp"

namespace splinecore {

/// What rounds the edge of two patches.
struct RoundedEdge {
  NurbsPatch first;    ///< the trimmed patches, up to where the ball touches them
  NurbsPatch fillet;   ///< u along the edge, v from the first patch to the second one, by arcs
  NurbsPatch second;
  double error = 0.0;  ///< how far one of the three was found to be from where it should be
};

/// A ball rolls along the edge that two patches have in common, on the side where they are nearer to each other, and touches
/// both: the surface between (Rossignac and Requicha 1984; row S21).
///
/// The three have their sides in common: the same control points on the same knots, so that a set of them shares its edges and a
/// mesh has no crack; to that end patches gain degrees and knots along the edge. Where the ball touches both patches at the same
/// parameter along the edge cross sections are arcs of circles: about the center of the ball, and where its radius changes of those
/// in which balls leave their common hull. Where it does not, as sides beside the edge slant, planes across it are no planes of
/// symmetry, or closed edges begin elsewhere or run at different paces, lines across go over several positions of it, so that the
/// fillet ends where both patches do. Patches whose contact is a line of parameters are cut exactly; what closes to a point may
/// then begin elsewhere.
/// @param radii  at parameters of the first patch along the edge, between which they go without overshoot
/// @param tolerance  none: 2^-20 of the size of the patches
/// @throws InvalidShape if the sides are not one edge, their tangent planes agree, a radius is not above 0, changes faster than the
///         ball rolls on, or is too large for a patch, so that the ball does not touch it, or a side is a seam; ToleranceNotReached, which says
///         where along the edge, and whether by a knot of a patch or by the radius.
RoundedEdge fillet(const NurbsPatch& first, Border first_side, const NurbsPatch& second, Border second_side,
                   std::span<const RailNumber> radii, std::optional<double> tolerance = {});

}  // namespace splinecore
