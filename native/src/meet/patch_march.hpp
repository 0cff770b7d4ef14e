#pragma once

#include <functional>
#include <span>

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// So many places one curve has at most.
inline constexpr std::size_t kMostPlaces = std::size_t{1} << 18;

struct MarchLimits {
  PatchContact contact;                   ///< how the patches meet along it
  std::span<const SectionTouch> touches;  ///< where curves end
  double tolerance;                       ///< how far they are from the patches
  std::function<bool(const SectionPlace&)> is_known{};  ///< of a place on the side of a piece: where it is known curves end
  std::size_t most_places = kMostPlaces;  ///< after so many it is refused
};

/// The whole curve through a place: both ways, to borders, poles, places where the patches touch, where one of them is
/// folded or has no normal for another reason, and where it comes to a curve that is known or to itself; or round.
SectionTrace traced(const TwoPatches& patches, const SectionPlace& seed, const MarchLimits& limits);

}  // namespace splinecore
#pragma GCC visibility pop
