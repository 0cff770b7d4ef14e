#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether the second one of two patches is worked on first, so that what is found does not depend on which was given first:
/// the one that spreads farther is the first one, which motions, finer knots and other directions of parameters do not
/// change; of two that spread alike, as copies do, their numbers tell.
bool are_exchanged(const NurbsPatch& a, const NurbsPatch& b);

}  // namespace splinecore
#pragma GCC visibility pop
