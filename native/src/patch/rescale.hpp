#pragma once

#include <array>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// scale_of() the knots of both directions.
std::array<int, 2> parameter_scales(const NurbsPatch& patch);

/// The patch with the knots of both directions divided by these powers of two.
NurbsPatch divided(const NurbsPatch& patch, const std::array<int, 2>& parameters);

}  // namespace splinecore
#pragma GCC visibility pop
