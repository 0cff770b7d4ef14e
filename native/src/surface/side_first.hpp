#pragma once

#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A patch turned so that its side is v_start; u runs along it as before.
inline NurbsPatch with_side_first(const NurbsPatch& patch, Border side) {
  const NurbsPatch upright = axis_of(side) == Axis::u ? swapped(patch) : patch;
  return is_at_end(side) ? reversed(upright, Axis::v) : upright;
}

/// The other way round.
inline NurbsPatch with_side_back(const NurbsPatch& patch, Border side) {
  const NurbsPatch upright = is_at_end(side) ? reversed(patch, Axis::v) : patch;
  return axis_of(side) == Axis::u ? swapped(upright) : upright;
}

}  // namespace splinecore
#pragma GCC visibility pop
