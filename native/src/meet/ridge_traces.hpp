#pragma once

#include <vector>

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Curves along which two patches meet, told apart by what they do across them.
struct SortedTraces {
  std::vector<SectionTrace> crossing;
  std::vector<SectionTrace> ridges;  ///< creases along which they touch: on both sides one is on the same side of the other
};

/// Takes creases along which patches but touch out of curves that run along them, on both sides of a crease, there and back.
/// Where they cross along one it is given once, from whichever pieces beside it that was found.
SortedTraces without_ridges(const TwoPatches& patches, const std::vector<SectionTrace>& traces, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
