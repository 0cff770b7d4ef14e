#pragma once

#include <span>

#include "base/placement.hpp"
#include "surface_rule.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The integral over all patches, each in its place. Their pieces between knots are halved where weights differ much,
/// and where that changes the result, until all changes together are within the tolerance, relative to the value, or
/// within rounding. The error is those changes, which for smooth surfaces is far above the truth, and rounding.
/// @param what  the beginning of the sentence: "the area cannot be found"
/// @throws ToleranceNotReached if that takes too many pieces, InvalidShape where weights or sizes differ too much.
Approximation<double> surface_integral(std::span<const NurbsPatch* const> patches, const Placement& placement,
                                       Integrand integrand, double tolerance, const char* what);

/// @throws InvalidShape unless it is a positive, finite number.
void require_relative(double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
