#pragma once

#include <functional>

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Adds the places of a line that two patches have in common, so close that each step is within a tolerance of both.
/// @param place  by a share of the line, in [0, 1]
void add_places(SectionTrace& trace, const TwoPatches& patches, const std::function<SectionPlace(double)>& place, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
