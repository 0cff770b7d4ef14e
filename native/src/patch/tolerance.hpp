#pragma once

#include <optional>

#include "splinecore/base/approximation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A patch that stands for another, and how far the two lie apart.
/// @param what  the beginning of the sentence with which it is refused
/// @throws ToleranceNotReached
Approximation<NurbsPatch> within(std::optional<double> tolerance, const NurbsPatch& original, NurbsPatch value,
                                 const char* what);

}  // namespace splinecore
#pragma GCC visibility pop
