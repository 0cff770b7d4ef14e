#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "height_difference.hpp"
#include "patch_approach.hpp"
#include "patch_part.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Parameters of two patches: u and v of the first one, then of the second one.
using FourParameters = std::array<double, 4>;

inline FourParameters parameters_of(const PatchSpots& at) noexcept { return {at[0], at[1], at[2], at[3]}; }

/// Parts of two patches that cross: for any two places that they have in common the parameters of known sign go the same way,
/// all together. So for each value of the leading one there is a place at most.
struct CrossingPart {
  PatchPart a;
  PatchPart b;
  std::array<int, 4> signs;  ///< which way parameters go along the cross product of both normals; 0 where that is not known
  std::size_t lead;          ///< the parameter that surely goes on the most

  const Interval& range(std::size_t parameter) const noexcept {
    return parameter < 2 ? a.range[parameter] : b.range[parameter - 2];
  }
  double size() const noexcept { return std::max(a.largest_size(), b.largest_size()); }

  /// How long lines along a parameter are in the part.
  double length_along(std::size_t parameter) const noexcept {
    return parameter < 2 ? a.size[parameter] : b.size[parameter - 2];
  }

  FourParameters middle() const noexcept {
    return {a.range[0].middle(), a.range[1].middle(), b.range[0].middle(), b.range[1].middle()};
  }
  bool holds(const FourParameters& at) const noexcept;
};

/// @returns none unless normals differ, by more than places may be rounded, and a parameter leads
std::optional<CrossingPart> crossing_part(PatchPart a, PatchPart b, double rounding);

/// @returns none unless a parameter leads
std::optional<CrossingPart> crossing_part(PatchPart a, PatchPart b, const HeightDifference& difference);

/// The part within a range of a parameter. Parts of a crossing part are ones.
CrossingPart within(const CrossingPart& part, std::size_t parameter, const Interval& kept);

/// Halves of the larger one of both.
std::pair<CrossingPart, CrossingPart> halves(const CrossingPart& part);

}  // namespace splinecore
#pragma GCC visibility pop
