#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A side of one of some patches.
struct SideOfPatch {
  std::size_t patch;
  Border border;
  friend bool operator==(const SideOfPatch&, const SideOfPatch&) = default;
};

/// The sides around one open end of patches, in order, and behind them those around others, as holes in it.
using OpenEnd = std::vector<SideOfPatch>;

/// Patches within a rim of closed loops of curves, in any directions: a loop within a loop is a hole,
/// and a loop within a hole is filled again. u runs along a side, as that does and on its knots, v from there
/// to a point that sees all of the rim, by segments. Sides are what they are, control points and all. A rim that is seen whole
/// from nowhere, and one with holes, is cut by chords between ends of sides; where these do not do, sides are cut at corners, and then in halves.
///
/// Those of a plane rim are plane, and do not fold: that sides are seen from the point is proved by Bernstein coefficients. Of
/// another rim that is so as it is seen against the plane nearest to it.
/// @returns the patches, with normals on the side from which the first side runs to the left, or of several loops the widest one,
///          and how far the rim's points are from a plane
/// @throws InvalidShape if there is no side, the sides do not close up, one has a weight that is not positive or lies at infinity,
///         or the rim crosses itself or a hole in it, encloses almost no area, or has too many corners for chords to be found
Approximation<std::vector<NurbsPatch>> rim_filling(std::span<const NurbsCurve> sides);

/// The open ends of patches: sides that no other patch shares, and that close up.
/// @throws InvalidShape if a patch is in several pieces, more than two open sides end in one point, or one ends where no other does
std::vector<OpenEnd> open_ends(std::span<const NurbsPatch> patches);

/// The patches and, behind them, a rim_filling() of each of these open ends, with the same control points along its sides and
/// normals on the same side as those of the patch beside it. Closed sets then have all normals outwards; of those with other
/// open ends that is told as if those were filled, too. A patch is cut where its rim has to be. Patches about holes are turned, and
/// those that are bound to them, where their normals are on the other side than those about the border.
/// @returns patches, and how far rims are from planes
/// @throws InvalidShape as rim_filling(), or if a patch that has to be cut shares the side opposite to the end
Approximation<std::vector<NurbsPatch>> capped(std::span<const NurbsPatch> patches, std::span<const OpenEnd> ends);

}  // namespace splinecore
