#pragma once

#include <string>

#include "splinecore/base/errors.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Calls make(), and names the direction in what it throws.
template <class Make>
auto along(const char* axis, Make make) {
  try {
    return make();
  } catch (const InvalidShape& error) {
    throw InvalidShape("along " + std::string(axis) + ": " + error.what());
  }
}

}  // namespace splinecore
#pragma GCC visibility pop
