#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

struct GatheredPoles {
  NurbsPatch patch;
  double moved;  ///< the largest distance of a control point
};

/// The patch with sides whose points all lie so near to their middle in one point, as they were meant where rounding came
/// between: normals along them are noise, and those of the pole that they then are are not.
GatheredPoles with_gathered_poles(const NurbsPatch& patch, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
