#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "mesh_spans.hpp"
#include "splinecore/patch/panels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The number of the axis that a side runs along: 0 for u, 1 for v.
inline int side_runs_along(int side) { return side < 2 ? 1 : 0; }

/// How many strips a mesh by count has in every span, and where its vertices lie on edges.
class CountPlan {
 public:
  CountPlan(const PatchSet& set, const std::vector<Panel>& panels, int resolution_u, int resolution_v);

  /// Of u and v of a patch.
  const std::array<std::vector<MeshSpan>, 2>& spans_of(std::size_t patch) const { return spans_[patch]; }
  const std::array<int, 2>& resolution_of(std::size_t patch) const { return resolutions_[patch]; }

  /// The first of the spans that a panel has, and the one behind the last.
  std::pair<int, int> spans(std::size_t panel, int axis) const;
  int strips(std::size_t panel, int axis) const;

  /// Scaled places along each edge, from 0 to 1.
  const std::vector<std::vector<double>>& edges() const noexcept { return edges_; }
  bool has_places_of_edge(std::size_t panel, int side) const;

 private:
  std::vector<double> places(std::size_t panel, int side) const;
  void choose_edge_places();
  bool raise_narrow_panels();

  const std::vector<Panel>& panels_;
  std::vector<std::array<std::vector<MeshSpan>, 2>> spans_;  // of each patch
  std::vector<std::array<int, 2>> resolutions_;              // of each patch
  std::vector<std::vector<double>> edges_;
};

}  // namespace splinecore
#pragma GCC visibility pop
