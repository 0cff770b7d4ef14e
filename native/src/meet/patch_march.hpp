#pragma once

#include <functional>
#include <span>

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

struct MarchLimits {
  PatchContact contact;                   ///< how the patches meet along it
  std::span<const SectionTouch> touches;  ///< where curves end
  double tolerance;                       ///< how far they are from the patches
  std::function<bool(const SectionPlace&)> is_known{};  ///< of a place on the side of a piece: where it is known curves end
};

/// The whole curve through a place: both ways, to borders, poles, places where the patches touch, where one of them is
/// folded or has no normal for another reason, and where it comes to a curve that is known or to itself; or round. Where no
/// place is found ahead, however short the step, and those that touch do not part either, it is lost.
SectionTrace traced(const TwoPatches& patches, const SectionPlace& seed, const MarchLimits& limits);

}  // namespace splinecore
#pragma GCC visibility pop
