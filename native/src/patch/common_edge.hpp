#pragma once

#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Two patches that are clamped across a side and alike along it.
struct CommonEdge {
  NurbsPatch a;
  NurbsPatch b;
  /// For each point along the side of a, the place of b's along its own.
  std::vector<std::size_t> columns_of_b;
};

/// The same surfaces with one degree and the same knots along two sides, the knots of each on its own domain.
/// A knot that lies within a few roundings of one of the other's is taken for it.
/// @param is_reversed  b's parameter along the side runs against a's
/// @throws InvalidShape if knots of one cannot be told apart on the domain of the other.
CommonEdge on_common_edge(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b, bool is_reversed);

}  // namespace splinecore
#pragma GCC visibility pop
