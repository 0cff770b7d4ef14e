#pragma once

#include <optional>

#include "splinecore/patch/isocurve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The angle that seam_continuity() finds between the tangent planes of two patches, without what takes it longer.
/// @throws InvalidShape as it does
double seam_angle(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                  std::optional<bool> reversed = {});

}  // namespace splinecore
#pragma GCC visibility pop
