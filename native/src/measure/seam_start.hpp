#pragma once

#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The second patch with a closed side begun where that of the first begins, if it passes there; otherwise, or where it begins
/// there, as it is.
NurbsPatch begun_beside(const NurbsPatch& first, Border side_a, const NurbsPatch& second, Border side_b);

}  // namespace splinecore
#pragma GCC visibility pop
