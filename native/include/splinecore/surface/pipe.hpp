#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/surface/sweep.hpp"

namespace splinecore {

/// What closes a pipe at its ends.
enum class PipeCaps {
  none,
  flat,   ///< discs
  round,  ///< half spheres
};

/// A pipe about a curve: its mantle, and then the caps at its start and its end, exact and with the same control points
/// along their rims; normals outwards. Row S20.
///
/// A sweep() of a circle, periodic in u, at right angles to the curve everywhere. The radius goes from one to the next
/// without overshoot, before the first and behind the last it stays. A closed curve has no caps.
/// @param radii  at parameters of the curve, which increase
/// @param scale  of radii: what x of it is at the parameters of the curve, as SweepOptions::scale
/// @returns the patches, and how far rows of the mantle were found to be from where they should be
/// @throws InvalidShape if there is no radius, or one is not above 0; ToleranceNotReached and InvalidShape as sweep()
Approximation<std::vector<NurbsPatch>> pipe(const NurbsCurve& axis, std::span<const RailNumber> radii,
                                            PipeCaps caps = PipeCaps::none, std::optional<double> tolerance = {},
                                            std::optional<NurbsCurve> scale = {});

}  // namespace splinecore
