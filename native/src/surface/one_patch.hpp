#pragma once

#include <optional>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patch of which these are the parts, u of the second one going on from that of the first, over [0, 1]; none if they are
/// not. Both are clamped.
std::optional<NurbsPatch> one_patch(const NurbsPatch& first, const NurbsPatch& second);

}  // namespace splinecore
#pragma GCC visibility pop
