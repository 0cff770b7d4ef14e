#pragma once

#include <algorithm>
#include <functional>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether all are above `noise`, or all below its negative. What has such Bernstein coefficients is zero nowhere.
template <class Values, class Projection = std::identity>
bool has_one_sign(const Values& values, Projection projection = {}, double noise = 0.0) {
  const auto [low, high] = std::ranges::minmax(values, {}, projection);
  return std::invoke(projection, low) > noise || std::invoke(projection, high) < -noise;
}

}  // namespace splinecore
#pragma GCC visibility pop
