#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/tessellate/mesh_spans.hpp"

namespace splinecore {

/// A rectangle in the parameters of a patch.
struct Cell {
  Place u0 = 0;
  Place u1 = 0;
  Place v0 = 0;
  Place v1 = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// How fine a mesh is to be.
struct Fineness {
  double distance;  ///< no point of the surface lies farther from the mesh; infinite for any
  double angle;     ///< radians, between normals at 3 x 3 places of each face, which is a 1024th of a span at least;
                    ///< infinite for any
};

/// Rectangles that tile a part of a patch, each fine enough, none across a knot and none more than 16 times as long
/// as wide; in a closed direction none wider than a third, so that no two faces have the same corners.
/// @param spans  of u and v
/// @throws InvalidShape if that takes more than 2^21, or a weight is not above 0 however small they are.
std::vector<Cell> cells_of(const NurbsPatch& patch, const std::array<std::vector<MeshSpan>, 2>& spans,
                           const Cell& whole, const Fineness& fineness, bool closed_u, bool closed_v);

/// Cells that tile a rectangle, and every place on their sides where a vertex is.
class CellGrid {
 public:
  CellGrid(const Cell& whole, std::vector<Cell> cells);

  const Cell& whole() const noexcept { return whole_; }
  const std::vector<Cell>& cells() const noexcept { return cells_; }

  /// The places along `axis` with a vertex, on the line where the other parameter is `line`, between two, growing.
  std::vector<Place> between(Axis axis, Place line, Place from, Place to) const;

  /// Adds a vertex; whether it is new.
  bool add(Axis axis, Place line, Place at);

  /// Splits cells until each has at most one vertex inside a side, and not one on all four.
  /// @throws InvalidShape if that takes more than 2^21.
  void balance();

 private:
  int count_between(Axis axis, Place line, Place from, Place to) const;
  bool split(std::size_t i);
  void add_corners(const Cell& cell);

  Cell whole_;
  std::vector<Cell> cells_;
  /// (line, place along it), for lines along u and along v.
  std::set<std::pair<Place, Place>> along_u_;
  std::set<std::pair<Place, Place>> along_v_;
};

}  // namespace splinecore
