#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// To which part of itself an area or a volume is found unless asked otherwise.
inline constexpr double kAreaTolerance = 1e-12;

/// The area of a patch (lecture rows S19, S20): the integral of |S_u x S_v|.
///
/// Gauss's rule of 12 x 12 nodes on each pair of spans, quartered where that changes the result.
/// A fold inside a cell is found by its change; one that is narrower than a hundredth of a cell, beside its
/// edge, may be missed.
/// @param tolerance  relative to the area; where rounding of the coordinates is more, the error says so
/// @throws InvalidShape if the tolerance is not positive; PointAtInfinity if the patch runs to infinity;
///         ToleranceNotReached, as for a patch that folds back on itself along a line that is no line of its
///         parameters.
Approximation<double> area(const NurbsPatch& patch, double tolerance = kAreaTolerance);

/// The sum of the areas of all patches.
Approximation<double> area(const PatchSet& set, double tolerance = kAreaTolerance);

/// The volume that a closed set of patches encloses: a third of the integral of S · (S_u x S_v), by Gauss's
/// theorem. Positive where the normals point outwards, negative where inwards.
///
/// Closed: every side of every patch is a pole, lies across a periodic direction, or lies on the same points
/// as another one that runs the opposite way around its patch.
/// @throws InvalidShape naming a side that is free, or that runs the same way as the one beside it; and as area().
Approximation<double> volume(const PatchSet& set, double tolerance = kAreaTolerance);

}  // namespace splinecore
