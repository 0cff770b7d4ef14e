#include "cell_grid.hpp"

#include <algorithm>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

bool is_along_u(int side) { return side % 2 == 0; }

std::pair<Place, Place> range_along(const MeshCell& range, int side) {
  return is_along_u(side) ? std::pair{range.u0, range.u1} : std::pair{range.v0, range.v1};
}

/// The side of the border that a side of a cell can lie on.
std::size_t border_of(int side) { return std::array<std::size_t, 4>{2, 1, 3, 0}[side]; }

/// Which of the two cells at a line one is that has it as this side: before the line, or behind it.
std::size_t place_at_line(int side) { return side == 1 || side == 2 ? 0 : 1; }

}  // namespace

CellGrid::CellGrid(std::vector<Place> u, std::vector<Place> v, std::span<const std::vector<Cut>> rows)
    : whole_{u.front(), u.back(), v.front(), v.back()} {
  const std::size_t count_u = u.size() - 1;
  const std::size_t count_v = v.size() - 1;
  for (std::size_t side = 0; side < 4; ++side) {
    for (const Place at : side < 2 ? v : u) borders_[side].push_back({at, -1});
  }
  const auto is_inside = [](std::size_t i, std::size_t count) { return i > 0 && i < count; };
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return is_inside(i, count_u) && is_inside(j, count_v) ? static_cast<std::int32_t>((i - 1) * (count_v - 1) + j - 1)
                                                          : -1;
  };
  // Lines u = u[i] between the rows, then lines v = v[j] between the columns.
  const auto line_u = [&](std::size_t i, std::size_t j) {
    return is_inside(i, count_u) ? static_cast<std::int32_t>((i - 1) * count_v + j) : -1;
  };
  const auto line_v = [&](std::size_t i, std::size_t j) {
    return is_inside(j, count_v) ? static_cast<std::int32_t>((count_u - 1) * count_v + i * (count_v - 1) + j - 1) : -1;
  };
  lines_.resize((count_u - 1) * count_v + count_u * (count_v - 1));
  inner_count_ = static_cast<std::int32_t>((count_u - 1) * (count_v - 1));
  for (std::size_t i = 0; i < count_u; ++i) {
    const Cut* cut = rows[i].data();
    for (std::size_t j = 0; j < count_v; ++j) {
      grow({{u[i], u[i + 1], v[j], v[j + 1]},
            {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)},
            {line_v(i, j), line_u(i + 1, j), line_v(i, j + 1), line_u(i, j)}},
           cut);
    }
  }
  is_touched_.assign(cells_.size(), 1);
}

/// Adds the cells that a rectangle is cut into, and moves behind its cuts.
void CellGrid::grow(GridCell cell, const Cut*& cut) {
  constexpr std::size_t kSteps = 100;
  while (*cut != Cut::none) {
    breathe(kSteps);
    const auto [first, second] = halves(cell, *cut++ == Cut::across_u ? Axis::u : Axis::v);
    grow(first, cut);
    cell = second;
  }
  ++cut;
  require_room_for_cells(cells_.size());
  cells_.push_back(cell);
  put(static_cast<std::int32_t>(cells_.size()) - 1);
}

std::int32_t CellGrid::add_line(std::int32_t parent) {
  lines_.push_back({.parent = parent});
  return static_cast<std::int32_t>(lines_.size()) - 1;
}

std::pair<CellGrid::Border::iterator, bool> CellGrid::put_on_border(std::size_t side, Place at) {
  Border& border = borders_[side];
  const auto next = std::ranges::lower_bound(border, at, {}, &BorderVertex::at);
  if (next != border.end() && next->at == at) return {next, false};
  return {border.insert(next, {at, -1}), true};
}

/// Says to the sides of a cell that it is theirs.
void CellGrid::put(std::int32_t number) {
  const GridCell& cell = cells_[number];
  for (int side = 0; side < 4; ++side) {
    if (cell.lines[side] >= 0) {
      lines_[cell.lines[side]].cells[place_at_line(side)] = number;
    } else {
      put_on_border(border_of(side), range_along(cell.range, side).first).first->cell = number;
    }
  }
}

/// Puts a vertex into the middle of a side.
CellGrid::Middle CellGrid::halve(const GridCell& cell, int side, Place at) {
  const std::int32_t line = cell.lines[side];
  if (line < 0) {
    put_on_border(border_of(side), at);
    return {-1, {-1, -1}};
  }
  if (lines_[line].middle < 0) {
    const std::int32_t first = add_line(line);
    add_line(line);
    lines_[line].halves = first;
    lines_[line].middle = inner_count_++;
  }
  return {lines_[line].middle, {lines_[line].halves, lines_[line].halves + 1}};
}

/// The halves of a cell, with the lower parameters first; nobody knows them yet.
std::pair<GridCell, GridCell> CellGrid::halves(const GridCell& cell, Axis axis) {
  GridCell first = cell;
  GridCell second = cell;
  const bool is_u = axis == Axis::u;
  const auto [from, to] = range_along(cell.range, is_u ? 0 : 1);
  const Place at = (from + to) / 2;
  const int low = is_u ? 0 : 3;   // the sides that are halved
  const int high = is_u ? 2 : 1;
  const Middle low_middle = halve(cell, low, at);
  const Middle high_middle = halve(cell, high, at);
  const std::int32_t between = add_line(-1);
  first.lines[low] = low_middle.lines[0];
  second.lines[low] = low_middle.lines[1];
  first.lines[high] = high_middle.lines[0];
  second.lines[high] = high_middle.lines[1];
  if (is_u) {
    first.range.u1 = second.range.u0 = at;
    first.lines[1] = second.lines[3] = between;
    first.corners[1] = second.corners[0] = low_middle.vertex;
    first.corners[2] = second.corners[3] = high_middle.vertex;
  } else {
    first.range.v1 = second.range.v0 = at;
    first.lines[2] = second.lines[0] = between;
    first.corners[3] = second.corners[0] = low_middle.vertex;
    first.corners[2] = second.corners[1] = high_middle.vertex;
  }
  return {first, second};
}

void CellGrid::on_border(int side, Place from, Place to, std::vector<Place>& found) const {
  const Border& border = borders_[side];
  for (auto next = std::ranges::upper_bound(border, from, {}, &BorderVertex::at);
       next != border.end() && next->at < to; ++next) {
    found.push_back(next->at);
  }
}

bool CellGrid::add(int side, Place at) {
  constexpr std::size_t kSteps = 50;
  breathe(kSteps);
  const auto [place, is_new] = put_on_border(side, at);
  if (!is_new) return false;
  auto before = place;
  while (before != borders_[side].begin() && before->cell < 0) --before;
  touch(before->cell);
  return true;
}

/// Touches the cells beside a line that has got a middle: those of which it is a side, or half a side. Of longer ones
/// the sides had more vertices before.
void CellGrid::touch_beside(const Line& line) {
  for (const std::int32_t cell : line.cells) touch(cell);
  if (line.parent < 0) return;
  for (const std::int32_t cell : lines_[line.parent].cells) touch(cell);
}

/// How many vertices there are inside a side, as far as two.
int CellGrid::count_on(const GridCell& cell, int side) const {
  if (cell.lines[side] < 0) {
    const auto [from, to] = range_along(cell.range, side);
    const Border& border = borders_[border_of(side)];
    const auto first = std::ranges::upper_bound(border, from, {}, &BorderVertex::at);
    const auto left = std::min<std::ptrdiff_t>(border.end() - first, 2);
    return left > 1 && first[1].at < to ? 2 : left > 0 && first[0].at < to ? 1 : 0;
  }
  const Line& line = lines_[cell.lines[side]];
  if (line.middle < 0) return 0;
  return lines_[line.halves].middle >= 0 || lines_[line.halves + 1].middle >= 0 ? 2 : 1;
}

/// Splits a cell if it must be; whether it was.
bool CellGrid::split(std::size_t i) {
  breathe(kStepsOfCell);
  const GridCell cell = cells_[i];
  const std::array<int, 4> counts{count_on(cell, 0), count_on(cell, 1), count_on(cell, 2), count_on(cell, 3)};
  const bool on_all = std::ranges::min(counts) > 0;
  const bool in_u = std::max(counts[0], counts[2]) > 1 || on_all;
  const bool in_v = !in_u && std::max(counts[1], counts[3]) > 1;
  const MeshCell& range = cell.range;
  if (!(in_u && range.u1 - range.u0 > 1) && !(in_v && range.v1 - range.v0 > 1)) return false;
  require_room_for_cells(cells_.size());
  const auto [first, second] = halves(cell, in_u ? Axis::u : Axis::v);
  cells_[i] = first;
  cells_.push_back(second);
  is_touched_.push_back(1);
  for (const int side : in_u ? std::array{0, 2} : std::array{1, 3}) {
    if (cell.lines[side] < 0) continue;
    Line& line = lines_[cell.lines[side]];
    line.cells[place_at_line(side)] = -1;
    touch_beside(line);
  }
  put(static_cast<std::int32_t>(i));
  put(static_cast<std::int32_t>(cells_.size()) - 1);
  return true;
}

void CellGrid::balance() {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!is_touched_[i]) continue;
      while (split(i)) again = true;
      is_touched_[i] = 0;
    }
  }
}

}  // namespace splinecore
