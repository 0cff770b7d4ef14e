#pragma once

#include <optional>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The curve of a patch whose image in its parameters is a curve in the plane (u, v), or at a distance from it along the
/// normals: by cubics with its tangents, halved until they are within the tolerance; its corners, and where it crosses
/// creases of the patch, are theirs: at a distance there is a gap. By the same parameter as the image. S18.
///
/// Beyond the domain the image continues over the seam where the patch is closed.
/// @param tolerance  none: 2^-20 of the size of the patch
/// @throws InvalidShape if the image leaves the domain, the tolerance is not above 0 or too small, or the patch has no
///         normal there and the distance is not 0; PointAtInfinity.
NurbsCurve curve_on_patch(const NurbsPatch& patch, const NurbsCurve& image, double distance = 0.0,
                          std::optional<double> tolerance = {});

}  // namespace splinecore
