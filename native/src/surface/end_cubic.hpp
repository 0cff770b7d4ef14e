#pragma once

#include <array>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A cubic over [0, 1] by its values and derivatives at both ends.
template <class Value>
struct EndCubic {
  std::array<Value, 2> values{};
  std::array<Value, 2> slopes{};

  Value at(double s) const {
    const double t = 1.0 - s;
    return t * t * (1.0 + 2.0 * s) * values[0] + s * s * (1.0 + 2.0 * t) * values[1] + s * t * (t * slopes[0] - s * slopes[1]);
  }
};

}  // namespace splinecore
#pragma GCC visibility pop
