#pragma once

#include <optional>
#include <string>

#include "splinecore/surface/loft.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Sees whether a patch that was made goes on from a neighbor as it is to: with tangent planes to 1e-4 radians, with curvatures
/// to 1e-3 of the largest one along the side. Closed sides, of which one is not periodic, are not seen where they begin
/// in different places.
/// @param name      of the neighbor
/// @param reversed  whether it runs against the patch; without, what is nearer
/// @throws ToleranceNotReached
void require_continuity(const NurbsPatch& made, Border border, const LoftNeighbor& neighbor, const std::string& name,
                        std::optional<bool> reversed = {});

}  // namespace splinecore
#pragma GCC visibility pop
