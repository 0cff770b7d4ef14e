#pragma once

#include <array>
#include <optional>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The patch between three or four curves that go round it, in any directions: the sum of both ruled surfaces between
/// opposite ones, less the bilinear patch of the corners (Coons 1967; Farin 2002, 22; row S21). Of three the last side is a
/// point.
///
/// u runs along the first curve, v from there to the third one. The sides are the curves, rational ones with their weights
/// multiplied so that these are 1 at both ends (standard_form()), which runs through them at another pace. Where ends lie
/// apart, by the tolerance at most, both are moved to their middle.
/// @param tolerance  none: 2^-30 of the size of the curves
/// @returns the patch, and how far an end was moved
/// @throws InvalidShape if there are not three or four curves, one is closed, or the weights at the ends of one have
///         not one sign; ToleranceNotReached where neighbours' ends lie farther apart.
Approximation<NurbsPatch> coons(std::span<const NurbsCurve> sides, std::optional<double> tolerance = {});

}  // namespace splinecore
