#pragma once

#include <array>
#include <optional>

#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is known of the difference of heights of two parts over a plane that both are nearly parallel to. Where patches
/// nearly touch it tells much larger parts of them apart than their normals do: how both bend is taken off.
struct HeightDifference {
  Interval range;                 ///< of it, wherever both are
  double least_slope = 0.0;       ///< 0 if the slope may be zero
  double bend = 0.0;              ///< how much it bends in the middle
  std::array<double, 4> leads{};  ///< how surely parameters go along the cross product of both normals, with signs
  bool is_beside = false;         ///< whether no place of one is above a place of the other

  bool are_apart(double distance) const noexcept {
    return is_beside || range.start > distance || range.end < -distance;
  }
  bool are_within(double distance) const noexcept {
    return !is_beside && range.start >= -distance && range.end <= distance;
  }
};

/// @returns none where they are no graphs over a plane, or where the difference and its slope may both be zero, and it
/// may be more than some roundings
std::optional<HeightDifference> height_difference(const PatchPart& a, const PatchPart& b, double rounding);

}  // namespace splinecore
#pragma GCC visibility pop
