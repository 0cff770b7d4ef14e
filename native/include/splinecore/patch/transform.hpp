#pragma once

#include <glm/mat4x4.hpp>

#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/hermite_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// The patch under an affine or projective map; the weights stay where it is affine (S9, S20).
///
/// A point that comes to lie at infinity has weight 0 and is a direction.
/// @param matrix  maps columns (x, y, z, w); affine if its last row is 0, 0, 0, 1
/// @throws InvalidShape if a number is not finite or every point goes to infinity.
NurbsPatch transformed(const NurbsPatch& patch, const glm::dmat4& matrix);
BezierPatch transformed(const BezierPatch& patch, const glm::dmat4& matrix);

/// @throws InvalidShape if the map is not affine: the image is no Hermite patch.
HermitePatch transformed(const HermitePatch& patch, const glm::dmat4& matrix);

/// The same patches on the image of the pool. @throws InvalidShape as of its patches
PatchSet transformed(const PatchSet& set, const glm::dmat4& matrix);

/// The same surface under the parameter t = rho u / ((1 - u) + rho u) of one direction, u and t in [0, 1] over
/// its domain, which stays: knots move, and the homogeneous points of a row are multiplied by one factor each
/// (Lee and Lucian 1991; The NURBS Book, 6.4; row S12).
///
/// A direction with knots beyond the map's pole is clamped first; a periodic one comes out plain.
/// @throws InvalidShape unless rho > 0, or if a weight would leave the range of numbers.
NurbsPatch moebius(const NurbsPatch& patch, Axis axis, double rho);

}  // namespace splinecore
