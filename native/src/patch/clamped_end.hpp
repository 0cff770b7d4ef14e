#pragma once

#include <cstddef>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether the functions of one end alone are there where the domain ends.
inline bool is_clamped_at(const KnotVector& knots, bool at_end) {
  if (knots.periodic()) return false;
  const auto all = knots.knots();
  const auto degree = static_cast<std::size_t>(knots.degree());
  return at_end ? all[all.size() - 1 - degree] == all[all.size() - 2] : all[degree] == all[1];
}

}  // namespace splinecore
#pragma GCC visibility pop
