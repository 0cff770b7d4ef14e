#pragma once

#include <cstddef>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How many control points at each end of a plain curve stay as they are.
struct Held {
  std::size_t start = 0;
  std::size_t end = 0;
};

}  // namespace splinecore
#pragma GCC visibility pop
