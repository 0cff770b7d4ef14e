#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cells.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A cell of a grid. Corners and sides are counter-clockwise; the sides are v = v0, u = u1, v = v1, u = u0.
struct GridCell {
  MeshCell range;
  std::array<std::int32_t, 4> corners{-1, -1, -1, -1};  ///< vertices inside the grid, -1 on its border
  std::array<std::int32_t, 4> lines{-1, -1, -1, -1};    ///< that the sides are, -1 on the border
};

/// Cells that tile a rectangle, and every vertex on their sides.
///
/// Cells are halves of halves of spans. So a line between two of them has a vertex in the middle if it has one at all,
/// and is halved there; only the border of the rectangle may have others, which add() puts there.
class CellGrid {
 public:
  /// @param u, v  where rectangles begin and end, growing
  /// @param rows  how each row of them, across u, is cut
  CellGrid(std::vector<Place> u, std::vector<Place> v, std::span<const std::vector<Cut>> rows);

  const MeshCell& whole() const noexcept { return whole_; }
  const std::vector<GridCell>& cells() const noexcept { return cells_; }

  /// How many vertices are inside; they have numbers from 0 on.
  std::size_t inner_count() const noexcept { return static_cast<std::size_t>(inner_count_); }

  /// The vertex in the middle of a line between cells, or -1.
  std::int32_t middle_of(std::int32_t line) const noexcept { return lines_[line].middle; }

  /// Appends the places with a vertex on the border between two, growing. Its sides are u = start, u = end, v = start,
  /// v = end.
  void on_border(int side, Place from, Place to, std::vector<Place>& found) const;

  /// Adds a vertex on a side of the border; whether it is new.
  bool add(int side, Place at);

  /// Splits cells until each has at most one vertex inside a side, and not one on all four.
  /// @throws InvalidShape if that takes more than 2^21.
  void balance();

 private:
  /// A line between two cells, or between what they were halved into.
  struct Line {
    std::int32_t middle = -1;  ///< its vertex there
    std::int32_t halves = -1;  ///< the first of two
    std::int32_t parent = -1;
    std::array<std::int32_t, 2> cells{-1, -1};  ///< of which it is a side: before it and behind it
  };
  struct BorderVertex {
    Place at;
    std::int32_t cell;  ///< that begins there, or -1
  };
  using Border = std::vector<BorderVertex>;
  struct Middle {
    std::int32_t vertex;
    std::array<std::int32_t, 2> lines;
  };

  void grow(GridCell cell, const Cut*& cut);
  std::pair<GridCell, GridCell> halves(const GridCell& cell, Axis axis);
  Middle halve(const GridCell& cell, int side, Place at);
  std::int32_t add_line(std::int32_t parent);
  void put(std::int32_t number);
  std::pair<Border::iterator, bool> put_on_border(std::size_t side, Place at);
  void touch(std::int32_t cell) {
    if (cell >= 0) is_touched_[cell] = 1;
  }
  void touch_beside(const Line& line);
  int count_on(const GridCell& cell, int side) const;
  bool split(std::size_t i);

  MeshCell whole_;
  std::vector<GridCell> cells_;
  std::vector<char> is_touched_;  ///< of each cell: it may have got a vertex since it was looked at
  std::vector<Line> lines_;
  std::int32_t inner_count_ = 0;
  std::array<Border, 4> borders_;  ///< u = start, u = end, v = start, v = end: growing
};

}  // namespace splinecore
#pragma GCC visibility pop
