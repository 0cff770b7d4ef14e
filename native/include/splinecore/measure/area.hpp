#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// To which part of itself an area or a volume is found unless asked otherwise.
inline constexpr double kAreaTolerance = 1e-12;

/// The area of a patch (lecture rows S19, S20): the integral of |S_u x S_v|.
///
/// Pieces between knots, each over separate parameters, are cut where weights differ much. On each, along either
/// direction, the rules of Gauss and Kronrod of 10 and 21 nodes; it is halved along those where they differ, until all
/// differences together are an eighth of the tolerance. A fold beside an edge, which no node sees, is seen at the edge.
/// @param tolerance  The area is off by at most so much of itself. Where rounding of the coordinates is more than that,
///                   as of a thin patch that lies askew, it is right to that rounding, and the error says so.
/// @throws InvalidShape if the tolerance is not positive, or where weights differ too much in size; PointAtInfinity if
///         the patch runs to infinity; ToleranceNotReached, with an error above the tolerance, if that takes more than
///         16 000 pieces and 4 for each pair of spans, as for many digits of a patch that folds back on itself along a
///         line that is no line of its parameters.
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
