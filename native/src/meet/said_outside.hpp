#pragma once

#include "near_space.hpp"
#include "splinecore/base/approximation.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a call in a space returns; the lengths of what it throws are those out there.
template <class Call>
auto said_outside(const NearSpace& space, const Call& call) {
  try {
    return call();
  } catch (const ToleranceNotReached& error) {
    throw error.times(space.length(1.0));
  }
}

}  // namespace splinecore
#pragma GCC visibility pop
