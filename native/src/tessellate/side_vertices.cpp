#include "side_vertices.hpp"

#include <numeric>

namespace splinecore {

SideVertices::SideVertices(const std::vector<Panel>& panels, std::span<const std::size_t> counts) : panels_(panels) {
  for (const std::size_t count : counts) edge_vertices_.emplace_back(count, -1);
  nodes_.resize(2 * counts.size() + 4 * panels.size());
  std::iota(nodes_.begin(), nodes_.end(), 0);
  node_vertices_.assign(nodes_.size(), -1);
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    for (const bool end_u : {false, true}) {
      for (const bool end_v : {false, true}) {
        const int a = corner_node(panel, end_u ? 1 : 0, end_v);
        const int b = corner_node(panel, end_v ? 3 : 2, end_u);
        nodes_[root(a)] = root(b);
      }
    }
  }
}

/// The node of a side's end; a side that is a point has one.
int SideVertices::corner_node(std::size_t panel, int side, bool at_end) const {
  const PanelSide& description = panels_[panel].sides[side];
  if (description.edge < 0) return static_cast<int>(2 * edge_vertices_.size() + 4 * panel) + side;
  return 2 * description.edge + (at_end != description.reversed ? 1 : 0);
}

int SideVertices::root(int node) {
  while (nodes_[node] != node) node = nodes_[node] = nodes_[nodes_[node]];
  return node;
}

std::int32_t& SideVertices::at(std::size_t panel, int side, std::size_t k) {
  const PanelSide& description = panels_[panel].sides[side];
  if (description.edge < 0) return node_vertices_[root(corner_node(panel, side, false))];
  std::vector<std::int32_t>& inner = edge_vertices_[description.edge];
  if (k > 0 && k + 1 < inner.size()) return inner[k];
  return node_vertices_[root(2 * description.edge + (k > 0 ? 1 : 0))];
}

}  // namespace splinecore
