#pragma once

#include <cstddef>
#include <vector>

#include "arrangement.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// An edge that goes the way of the first one of its group, or the other way.
struct GroupedEdge {
  std::size_t edge;
  bool is_reversed;
};

/// Edges that are one up to the tolerance.
using EdgeGroup = std::vector<GroupedEdge>;

/// All edges, each in a group of its own or with those that lie on it.
std::vector<EdgeGroup> edge_groups(const Arrangement& arrangement, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
