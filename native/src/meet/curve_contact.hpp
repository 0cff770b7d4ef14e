#pragma once

#include <optional>

#include "curve_cluster.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of curves that touch the place of the first one at which they have most derivatives in common.
/// @param near  its places within the tolerance of the second one
/// @returns none where there is none, as between two crossings or at a corner
std::optional<double> contact_in(const CurveCluster& cluster, const TwoCurves& curves, const Interval& near);

}  // namespace splinecore
#pragma GCC visibility pop
