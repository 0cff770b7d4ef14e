#pragma once

#include <optional>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The patch a distance away along its normals, to the other side where that is below 0 (Farin 2002, 8; Piegl and Tiller
/// 1999).
///
/// It has the weights of the patch, so that planes, cylinders, cones, spheres and tori come out exactly, but for rounding;
/// others are met at places between which spans are halved until it lies within the tolerance. A side whose control points
/// all lie within a sixteenth of the tolerance of their middle is a point, as it was meant; the error counts how far it went.
/// @param tolerance  none: 2^-20 of the size of the patch
/// @returns the offset, and how far it was found to be from where it should be
/// @throws InvalidShape if the distance is not finite, the patch has a crease, a gap or no normal somewhere, or is more
///         curved than the distance allows, so that the offset would fold; ToleranceNotReached.
Approximation<NurbsPatch> offset(const NurbsPatch& patch, double distance, std::optional<double> tolerance = {});

/// The closed set of a patch, its offset, and the ruled surfaces between their sides, all with normals outwards. Patches
/// next to each other have the same control points along their common side. Sides that are points, or meet another, as
/// where the patch closes, have no surface between.
/// @param from, to  the distances of the two large surfaces, which are not the same; 0 is the patch itself
/// @throws InvalidShape and ToleranceNotReached as offset()
Approximation<std::vector<NurbsPatch>> thickened(const NurbsPatch& patch, double from, double to,
                                                 std::optional<double> tolerance = {});

}  // namespace splinecore
