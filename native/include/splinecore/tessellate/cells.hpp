#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/tessellate/mesh_spans.hpp"
#include "splinecore/tessellate/place_table.hpp"

namespace splinecore {

/// A rectangle in the parameters of a patch.
struct MeshCell {
  Place u0 = 0;
  Place u1 = 0;
  Place v0 = 0;
  Place v1 = 0;
  friend bool operator==(const MeshCell&, const MeshCell&) = default;
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
std::vector<MeshCell> cells_of(const NurbsPatch& patch, const std::array<std::vector<MeshSpan>, 2>& spans,
                           const MeshCell& whole, const Fineness& fineness, bool closed_u, bool closed_v);

/// Cells that tile a rectangle, and every place on their sides where a vertex is.
///
/// Cells are halves of halves of spans. So where a line inside the rectangle has a vertex between two corners of a
/// cell, it has one in the middle, too; only the sides of the rectangle may have others, which add() puts there.
class CellGrid {
 public:
  CellGrid(const MeshCell& whole, std::vector<MeshCell> cells);

  const MeshCell& whole() const noexcept { return whole_; }
  const std::vector<MeshCell>& cells() const noexcept { return cells_; }

  /// Appends the places along `axis` with a vertex, on the line where the other parameter is `line`, between two,
  /// growing.
  void between(Axis axis, Place line, Place from, Place to, std::vector<Place>& found) const;

  /// Adds a vertex on a side of the rectangle, u = start, u = end, v = start or v = end; whether it is new.
  bool add(int side, Place at);

  /// The number that whoever writes the mesh gives to a vertex; -1 where there is none yet.
  std::int32_t& number_at(Place u, Place v) { return vertices_.find(u, v)->number; }

  /// Splits cells until each has at most one vertex inside a side, and not one on all four.
  /// @throws InvalidShape if that takes more than 2^21.
  void balance();

 private:
  int side_on(Axis axis, Place line) const;
  bool put(Place u, Place v, std::int32_t cell, int corner);
  void put_corners(std::size_t i);
  void touch(std::int32_t cell) {
    if (cell >= 0) is_touched_[cell] = 1;
  }
  void touch_beside(Axis axis, Place line, Place from, Place to);
  void touch_on_side(int side, Place at);
  bool has_middle(Axis axis, Place line, Place from, Place to) const;
  int count_between(Axis axis, Place line, Place from, Place to) const;
  bool split(std::size_t i);

  MeshCell whole_;
  std::vector<MeshCell> cells_;
  std::vector<char> is_touched_;  ///< of each cell: it may have got a vertex since it was looked at
  PlaceTable vertices_;
  std::array<std::vector<Place>, 4> sides_;  ///< u = start, u = end, v = start, v = end: places along them, growing
};

}  // namespace splinecore
