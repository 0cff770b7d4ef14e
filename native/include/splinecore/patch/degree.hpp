#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The same patch of a higher degree in one direction: every distinct knot has `times` copies more (S19, S20).
/// @throws InvalidShape if times is below 0 or the degree would exceed kMaxDegree.
NurbsPatch elevated(const NurbsPatch& patch, Axis axis, int times = 1);

/// A patch of a lower degree in one direction, whose lines are those of reduced() of a curve: the nearest in
/// their control points. A plain direction keeps its ends and comes back clamped.
///
/// The error is the largest distance at equal parameters, at most 2 % too large. Exact, but for rounding, where
/// the patch was raised from such a degree.
/// @throws InvalidShape unless 1 <= times < degree; ToleranceNotReached with a tolerance (a length) that
///         the error exceeds.
Approximation<NurbsPatch> reduced(const NurbsPatch& patch, Axis axis, int times = 1,
                                  std::optional<double> tolerance = {});

/// The same patch with a degree higher by `times`; its outer points keep every digit (The NURBS Book, eq. 5.36).
/// @throws InvalidShape if times is below 0 or the degree would exceed kMaxDegree.
BezierPatch elevated(const BezierPatch& patch, Axis axis, int times = 1);

/// A patch with a degree lower by `times` and the same ends: each step takes the nearest homogeneous lines in
/// the maximum norm (Lachance 1988; row S19). The error is as of the reduced() NurbsPatch.
/// @throws InvalidShape unless 1 <= times < degree; ToleranceNotReached.
Approximation<BezierPatch> reduced(const BezierPatch& patch, Axis axis, int times = 1,
                                   std::optional<double> tolerance = {});

}  // namespace splinecore
