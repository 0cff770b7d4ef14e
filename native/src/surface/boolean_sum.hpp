#pragma once

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// a + b - common of homogeneous points, over the domains of a (Gordon 1969): of two patches of which each has what the
/// other lacks, and the one that both have in common.
NurbsPatch boolean_sum(const NurbsPatch& a, const NurbsPatch& b, const NurbsPatch& common);

}  // namespace splinecore
#pragma GCC visibility pop
