#pragma once

#include "splinecore/patch/join.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How many derivatives both sides share, in some measure.
inline int order_of(PatchSmoothness smoothness) {
  if (smoothness == PatchSmoothness::c0) return 0;
  return smoothness == PatchSmoothness::c1 || smoothness == PatchSmoothness::g1 ? 1 : 2;
}

/// Whether they are equal by the parameters that both sides have.
inline bool is_parametric(PatchSmoothness smoothness) {
  return smoothness == PatchSmoothness::c1 || smoothness == PatchSmoothness::c2;
}

}  // namespace splinecore
#pragma GCC visibility pop
