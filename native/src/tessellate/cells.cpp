#include "splinecore/tessellate/cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "splinecore/base/errors.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/tessellate/flatness.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMaxCells = std::size_t{1} << 21;
/// A cell is no longer than this many times its width.
constexpr double kLongest = 16.0;
/// Cells this small are not split any more: 2^-22 of a span.
constexpr Place kSmallest = kSpan >> 22;

class Splitter {
 public:
  /// @param widest_u, widest_v  no cell is wider
  Splitter(const Fineness& fineness, Probe probe, Place widest_u, Place widest_v, std::vector<Cell>& cells)
      : fineness_(fineness), probe_(std::move(probe)), widest_u_(widest_u), widest_v_(widest_v), cells_(cells) {}

  void add(const Net& net, const Cell& cell) {
    const auto axis = axis_to_split(net, cell);
    if (!axis) {
      if (cells_.size() == kMaxCells) throw InvalidShape("the mesh would have more than 2^21 cells: allow more");
      cells_.push_back(cell);
      return;
    }
    const auto [before, after] = halved(net, *axis);
    Cell first = cell;
    Cell second = cell;
    if (*axis == Axis::u) {
      first.u1 = second.u0 = (cell.u0 + cell.u1) / 2;
    } else {
      first.v1 = second.v0 = (cell.v0 + cell.v1) / 2;
    }
    add(before, first);
    add(after, second);
  }

 private:
  std::optional<Axis> axis_to_split(const Net& net, const Cell& cell) const {
    if (cell.u1 - cell.u0 > widest_u_) return Axis::u;
    if (cell.v1 - cell.v0 > widest_v_) return Axis::v;
    const bool can_u = cell.u1 - cell.u0 > kSmallest;
    const bool can_v = cell.v1 - cell.v0 > kSmallest;
    const auto chosen = [&](double along_u, double along_v) -> std::optional<Axis> {
      if (!can_u && !can_v) return std::nullopt;
      if (!can_u || !can_v) return can_u ? Axis::u : Axis::v;
      return along_u >= along_v ? Axis::u : Axis::v;
    };
    const Bends bent = bends(net);
    if (bent.distance() == HUGE_VAL) {
      if (!can_u && !can_v) throw InvalidShape("the patch runs to infinity: no mesh is near it everywhere");
      return chosen(static_cast<double>(cell.u1 - cell.u0), static_cast<double>(cell.v1 - cell.v0));
    }
    if (bent.distance() > fineness_.distance) return chosen(bent.uu + bent.uv, bent.vv + bent.uv);
    if (fineness_.angle < HUGE_VAL) {
      const Turns turned = probe_.turns(net);
      if (turned.all > fineness_.angle) return chosen(turned.u, turned.v);
    }
    const Lengths sides = probe_.lengths(net);
    if (can_u && sides.v > 0.0 && sides.u > kLongest * sides.v) return Axis::u;
    if (can_v && sides.u > 0.0 && sides.v > kLongest * sides.u) return Axis::v;
    return std::nullopt;
  }

  const Fineness& fineness_;
  Probe probe_;
  Place widest_u_;
  Place widest_v_;
  std::vector<Cell>& cells_;
};

}  // namespace

std::vector<Cell> cells_of(const NurbsPatch& patch, const std::array<std::vector<MeshSpan>, 2>& spans,
                           const Cell& whole, const Fineness& fineness, bool closed_u, bool closed_v) {
  const BezierGrid grid = to_bezier(patch);
  std::vector<Cell> cells;
  const auto widest = [](Place length, bool closed) { return closed ? length / 3 : length; };
  const Probe probe(patch.knot_vector(Axis::u).degree(), patch.knot_vector(Axis::v).degree());
  Splitter splitter(fineness, probe, widest(whole.u1 - whole.u0, closed_u), widest(whole.v1 - whole.v0, closed_v),
                    cells);
  for (Place i = whole.u0 / kSpan; i < whole.u1 / kSpan; ++i) {
    for (Place j = whole.v0 / kSpan; j < whole.v1 / kSpan; ++j) {
      const int number = spans[0][i].number * grid.count_v + spans[1][j].number;
      const BezierPatch& piece = grid.patches[static_cast<std::size_t>(number)];
      splitter.add(net_of(piece), {i * kSpan, (i + 1) * kSpan, j * kSpan, (j + 1) * kSpan});
    }
  }
  return cells;
}

CellGrid::CellGrid(const Cell& whole, std::vector<Cell> cells) : whole_(whole), cells_(std::move(cells)) {
  for (const Cell& cell : cells_) add_corners(cell);
}

void CellGrid::add_corners(const Cell& cell) {
  for (const Place u : {cell.u0, cell.u1}) {
    for (const Place v : {cell.v0, cell.v1}) add(Axis::u, v, u);
  }
}

bool CellGrid::add(Axis axis, Place line, Place at) {
  const auto [u, v] = axis == Axis::u ? std::pair{at, line} : std::pair{line, at};
  along_v_.emplace(u, v);
  return along_u_.emplace(v, u).second;
}

std::vector<Place> CellGrid::between(Axis axis, Place line, Place from, Place to) const {
  const auto& places = axis == Axis::u ? along_u_ : along_v_;
  std::vector<Place> found;
  for (auto it = places.upper_bound({line, from}); it != places.end() && *it < std::pair{line, to}; ++it) {
    found.push_back(it->second);
  }
  return found;
}

/// As far as two.
int CellGrid::count_between(Axis axis, Place line, Place from, Place to) const {
  const auto& places = axis == Axis::u ? along_u_ : along_v_;
  int count = 0;
  for (auto it = places.upper_bound({line, from}); it != places.end() && *it < std::pair{line, to} && count < 2; ++it) {
    ++count;
  }
  return count;
}

/// Splits a cell if it must be; whether it was.
bool CellGrid::split(std::size_t i) {
  const Cell cell = cells_[i];
  const int low_v = count_between(Axis::u, cell.v0, cell.u0, cell.u1);
  const int high_v = count_between(Axis::u, cell.v1, cell.u0, cell.u1);
  const int low_u = count_between(Axis::v, cell.u0, cell.v0, cell.v1);
  const int high_u = count_between(Axis::v, cell.u1, cell.v0, cell.v1);
  const bool on_all = low_u > 0 && high_u > 0 && low_v > 0 && high_v > 0;
  const bool in_u = std::max(low_v, high_v) > 1 || on_all;
  const bool in_v = !in_u && std::max(low_u, high_u) > 1;
  Cell first = cell;
  Cell second = cell;
  if (in_u && cell.u1 - cell.u0 > 1) {
    first.u1 = second.u0 = (cell.u0 + cell.u1) / 2;
  } else if (in_v && cell.v1 - cell.v0 > 1) {
    first.v1 = second.v0 = (cell.v0 + cell.v1) / 2;
  } else {
    return false;
  }
  cells_[i] = first;
  cells_.push_back(second);
  add_corners(first);
  add_corners(second);
  return true;
}

void CellGrid::balance() {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      while (split(i)) again = true;
    }
  }
}

}  // namespace splinecore
