#pragma once

#include <glm/geometric.hpp>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Between two parameters at which a number has opposite signs, or a vector opposite directions, the one at which it is
/// zero, by halving.
template <class Function>
double zero_between(Interval in, Function function) {
  const auto way = function(in.end) - function(in.start);
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) (glm::dot(function(in.middle()), way) < 0.0 ? in.start : in.end) = in.middle();
  return in.middle();
}

}  // namespace splinecore
#pragma GCC visibility pop
