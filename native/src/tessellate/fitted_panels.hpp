#pragma once

#include <array>
#include <utility>
#include <vector>

#include "cell_grid.hpp"
#include "mesh_spans.hpp"
#include "splinecore/patch/panels.hpp"
#include "splinecore/tessellate/tessellation.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether a side of a panel runs along v.
inline bool is_along_v(int side) { return side < 2; }

/// A place on an edge, seen from one of its sides.
struct EdgePlace {
  double t;     ///< along the edge and scaled to [0, 1]; before slivers where some end there
  int slivers;  ///< how many do, one behind the other
};

/// The cells of all panels, fitted to one another: sides that are one edge have vertices at the same places.
class FittedPanels {
 public:
  /// @param panels  stay with the caller
  FittedPanels(const PatchSet& set, const std::vector<Panel>& panels, const Fineness& fineness, int threads);

  const CellGrid& grid(std::size_t panel) const { return grids_[panel]; }
  const std::vector<MeshSpan>& spans(std::size_t panel, Axis axis) const {
    return spans_[panel_of(panel).patch][axis == Axis::u ? 0 : 1];
  }

  EdgePlace edge_place(std::size_t panel, int side, Place place) const;

  /// The number of the place of an edge that is nearest.
  std::size_t on_edge(int edge, EdgePlace place) const;

  /// Of each edge: how many places with a vertex it has.
  std::vector<std::size_t> places_of_edges() const;

 private:
  const Panel& panel_of(std::size_t panel) const { return panels_[panel]; }
  void make_grids(const PatchSet& set, const Fineness& fineness, int threads);
  void fit();
  Place place_on(std::size_t panel, int side, double t) const;
  std::vector<Place> places_on(std::size_t panel, int side) const;
  double scaled(std::size_t panel, int side, Place place) const;
  std::vector<double> collect(std::size_t edge) const;
  std::vector<double> with_slivers(std::size_t edge, const std::vector<double>& places) const;
  bool spread(const std::vector<std::vector<double>>& edges);
  bool is_one_place(std::size_t edge, double a, double b) const;

  const std::vector<Panel>& panels_;
  std::vector<std::array<std::vector<MeshSpan>, 2>> spans_;  // of each patch
  std::vector<CellGrid> grids_;  // of each panel
  std::vector<std::vector<std::pair<std::size_t, int>>> edge_sides_;  ///< of each edge: panels and their sides on it
  /// Of each edge: scaled places with a vertex, growing from 0 to 1; once more for each end of a sliver there.
  std::vector<std::vector<double>> edge_places_;
};

}  // namespace splinecore
#pragma GCC visibility pop
