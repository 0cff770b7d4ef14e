#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "splinecore/patch/panels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The vertices on the sides of panels. Those of an edge are the same for all its sides, those of a corner for all
/// edges that end there, and a side that is a point has one.
class SideVertices {
 public:
  /// @param counts  of each edge: its vertices, both ends included
  SideVertices(const std::vector<Panel>& panels, std::span<const std::size_t> counts);

  /// Number k of a side's edge, counted along the edge; -1 where it has not been made yet.
  std::int32_t& at(std::size_t panel, int side, std::size_t k);

 private:
  int corner_node(std::size_t panel, int side, bool at_end) const;
  int root(int node);

  const std::vector<Panel>& panels_;
  std::vector<std::vector<std::int32_t>> edge_vertices_;
  /// Ends of edges, two for each, and then sides that are points, four for each panel: which of them are one.
  std::vector<int> nodes_;
  std::vector<std::int32_t> node_vertices_;
};

}  // namespace splinecore
#pragma GCC visibility pop
