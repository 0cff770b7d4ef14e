#pragma once

#include <optional>

#include "splinecore/build/offset.hpp"
#include "splinecore/region/region.hpp"

namespace splinecore {

/// All places that are no farther from a region than the distance; of a negative one the places in it that are farther than that
/// from all others. Holes close, outlines merge, and narrow parts are cut or vanish: nothing may be left.
///
/// Outlines are offset() one by one, trimmed; places around which all of them together run to the left are the result.
/// @param corner     of outlines, where they turn away from the offset
/// @param tolerance  how far the result may be from the offset; none: 2^-20 of the size of each outline
/// @throws InvalidShape if the distance or the tolerance is no such number, or an offset does not close; and as combined()
Region offset(const Region& region, double distance, OffsetCorner corner = OffsetCorner::round, std::optional<double> tolerance = {});

}  // namespace splinecore
