#pragma once

#include "splinecore/fit/interpolate_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// @throws InvalidShape if the grid has not so many points, or naming the first coordinate that is not finite.
void require_grid(const PointGrid& grid);

}  // namespace splinecore
#pragma GCC visibility pop
