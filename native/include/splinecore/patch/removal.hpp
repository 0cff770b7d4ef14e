#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The patch with `times` copies of a knot of one direction fewer; its lines are those of remove_knot() of a
/// curve: the nearest in their control points (S20; The NURBS Book, §5.4).
///
/// The error is the largest distance at equal parameters, at most 2 % too large. Exact, but for rounding, where
/// the patch is smooth enough at u.
/// @throws InvalidShape if u is not a knot inside the domain, or has fewer copies; of a periodic direction the
///         first knot keeps one copy. ToleranceNotReached with a tolerance (a length) that the error exceeds.
Approximation<NurbsPatch> remove_knot(const NurbsPatch& patch, Axis axis, double u, int times = 1,
                                      std::optional<double> tolerance = {});

/// The patch without the inner knots of one direction that can go while the error stays within the tolerance, least
/// error first.
/// @throws InvalidShape unless tolerance >= 0.
Approximation<NurbsPatch> remove_knots(const NurbsPatch& patch, Axis axis, double tolerance);

}  // namespace splinecore
