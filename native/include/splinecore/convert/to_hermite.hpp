#pragma once

#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/patch/hermite_patch.hpp"

namespace splinecore {

/// The same curve as a Hermite chain with a point at each distinct knot.
/// @throws InvalidShape if the degree is above 3, the weights differ, or the curve has a gap.
HermiteCurve to_hermite(const NurbsCurve& curve);

/// The same patch as a Hermite grid with corners at the distinct knots.
/// @throws InvalidShape if a degree is above 3, the weights differ, or the patch is not C1 at an
///         inner knot: a corner holds one tangent in each direction.
HermitePatch to_hermite(const NurbsPatch& patch);

}  // namespace splinecore
