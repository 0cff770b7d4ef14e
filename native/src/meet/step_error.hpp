#pragma once

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// By how much a step leaves the patches.
double error_of(const TwoPatches& patches, const SectionStep& step);

/// Whether between its ends a step is beyond a side of its pieces by more than a distance.
bool leaves_pieces(const TwoPatches& patches, const SectionStep& step, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
