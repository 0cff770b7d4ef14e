#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

struct GatheredPoles {
  NurbsPatch patch;
  double moved;  ///< a length: no point of the patch moved farther
};

/// The patch with sides whose control points all lie within a distance, a length, of their middle in one point, as they were
/// meant where rounding came between: normals along them are noise, and those of the pole that they then are are not. One
/// with weights that are not positive stays as it is.
GatheredPoles with_gathered_poles(const NurbsPatch& patch, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
