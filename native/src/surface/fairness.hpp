#pragma once

#include <span>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The integral of the sum of both squared principal curvatures: the same however patches are run through, moved or scaled.
double bending_of(std::span<const NurbsPatch> patches);

/// Whether the normals of a patch turn round inside of a span, from one place to one right beside it.
bool is_folded(const NurbsPatch& patch);

}  // namespace splinecore
#pragma GCC visibility pop
