#pragma once

#include <array>
#include <optional>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The patch between three or four curves that close up, in any directions: the sum of both ruled surfaces between
/// opposite ones, less the bilinear patch of the corners (Coons 1967; Farin 2002, 22; row S21). Of three the last side is a
/// point.
///
/// u runs along the first curve, v from there to the third one. The sides are the curves, rational ones with their weights
/// multiplied so that these are 1 at both ends (standard_form()), which changes their parametrization. Where ends lie
/// apart, by the tolerance at most, both are moved to their middle.
/// @param tolerance  none: 2^-30 of the size of the curves
/// @returns the patch, and how far an end was moved
/// @throws InvalidShape if there are not three or four curves, one is closed, or the weights at the ends of one have
///         not one sign; ToleranceNotReached where neighbors' ends lie farther apart.
Approximation<NurbsPatch> coons(std::span<const NurbsCurve> sides, std::optional<double> tolerance = {});

/// The patch between four curves that leaves them with derivatives that are given: the sum of the cubics from side to opposite
/// side in both directions, less the bicubic patch of the corners (Coons 1967; Farin 2002, 22.3; row S21).
///
/// Over [0, 1] in both directions, u along the first curve. Sides are the curves, at their own pace, rational ones with their
/// weights multiplied by a linear function that makes these 1 at both ends; derivatives too are those given, in homogeneous
/// points whose twists agree. One that is not given runs smoothly from that along one neighbor to that along the other, with the
/// twists of the bilinear patch (Adini), as far as these let nothing swing out, or of a neighbor's.
/// @param across     for each side none, or the derivative across it into the patch: vectors, as the points of a curve without
///                   weights that is run through as the side is
/// @param tolerance  how far ends may lie apart, and a derivative from that along the next side; none: 2^-30 of the size of
///                   the curves. Where two derivatives have different twists in a corner, their mean is taken.
/// @returns the patch, and the most by which an end was moved, or a derivative changed
/// @throws InvalidShape if there are not four curves and derivatives, a curve is closed or jumps, an end lies at infinity, a
///         derivative has weights, or weights would not stay positive; ToleranceNotReached naming sides that do not meet, or the
///         one across which the derivative is not that along the next.
Approximation<NurbsPatch> bicubic_coons(std::span<const NurbsCurve> sides, std::span<const std::optional<NurbsCurve>> across,
                                        std::optional<double> tolerance = {});

}  // namespace splinecore
