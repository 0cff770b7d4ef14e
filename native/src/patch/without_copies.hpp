#pragma once

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patch with as few copies of a knot as leave the distance from `original`, which is the error, within the
/// tolerance.
/// @param best  the patch with its error
Approximation<NurbsPatch> without_copies(Approximation<NurbsPatch> best, Axis axis, double u,
                                         const NurbsPatch& original, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
