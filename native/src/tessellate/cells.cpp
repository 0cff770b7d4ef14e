#include "splinecore/tessellate/cells.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/tessellate/flatness.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMaxCells = std::size_t{1} << 21;
/// What a cell costs, about, in steps of breathe().
constexpr std::size_t kStepsOfCell = 1000;
/// A cell is no longer than this many times its width.
constexpr double kLongest = 16.0;
/// A line along a cell bows by no more than this part of the width, so that faces neither fold nor become slivers.
constexpr double kDeepest = 0.125;
/// Cells this small are not split any more: 2^-22 of a span.
constexpr Place kSmallest = kSpan >> 22;
/// And these not for their normals, which turn at once where a surface folds.
constexpr Place kSmallestTurn = kSpan >> 10;

/// @throws InvalidShape if there are as many cells as there may be.
void require_room(const std::vector<Cell>& cells) {
  if (cells.size() >= kMaxCells) throw InvalidShape("the mesh would have more than 2^21 cells: allow more");
}

/// Something along u and along v.
struct Both {
  double u;
  double v;
};

class Splitter {
 public:
  /// @param widest  no cell is wider
  Splitter(const Fineness& fineness, Probe probe, const std::array<Place, 2>& widest, std::vector<Cell>& cells)
      : fineness_(fineness), probe_(std::move(probe)), widest_(widest), cells_(cells) {}

  /// Tiles the cell that a piece fills.
  void add_piece(const Net& net, const Cell& cell) {
    piece_ = cell;
    add(net, cell);
  }

 private:
  void add(const Net& net, const Cell& cell) {
    breathe(kStepsOfCell + net.points.size() * static_cast<std::size_t>(net.rows + net.columns));
    const auto axis = axis_to_split(net, cell);
    if (!axis) {
      require_room(cells_);
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

  std::optional<Axis> axis_to_split(const Net& net, const Cell& cell) const {
    if (cell.u1 - cell.u0 > widest_[0]) return Axis::u;
    if (cell.v1 - cell.v0 > widest_[1]) return Axis::v;
    const bool can_u = cell.u1 - cell.u0 > kSmallest;
    const bool can_v = cell.v1 - cell.v0 > kSmallest;
    const Bends bent = bends(net);
    if (bent.distance() == HUGE_VAL) {
      if (!can_u && !can_v) throw InvalidShape("the patch runs to infinity: no mesh is near it everywhere");
      return can_u && (!can_v || cell.u1 - cell.u0 >= cell.v1 - cell.v0) ? Axis::u : Axis::v;
    }
    const Look look = probe_.look(net);
    for (const auto& needed : {by_distance(net, bent, look), by_sides(net, bent, cell), by_angle(look, cell), by_form(look)}) {
      if (!needed) continue;
      const bool is_u = needed->u >= needed->v;
      if (is_u ? can_u : can_v) return is_u ? Axis::u : Axis::v;
      if (can_u || can_v) return can_u ? Axis::u : Axis::v;
    }
    return std::nullopt;
  }

  /// How much each direction adds to the distance from a face, where that is too large.
  ///
  /// A point of the piece lies off the plane of its face by as much as its height bends. In that plane it lies off the
  /// place of its parameters, and perhaps over a face beside it, whose plane falls away by the angle between them.
  std::optional<Both> by_distance(const Net& net, const Bends& bent, const Look& look) const {
    if (bent.distance() <= fineness_.distance) return std::nullopt;
    const glm::dvec3& normal = look.normals[4];
    if (normal == glm::dvec3(0.0)) return Both{bent.uu + bent.uv, bent.vv + bent.uv};
    const Bends height = bends_along(net, normal);
    const double fall = std::sin(std::min(look.turns().all, 0.5 * std::numbers::pi));
    if (height.distance() + fall * bent.distance() <= fineness_.distance) return std::nullopt;
    return Both{height.uu + height.uv + fall * (bent.uu + bent.uv), height.vv + height.uv + fall * (bent.vv + bent.uv)};
  }

  /// On the border of a piece, where the next one may go on in any direction, the line itself must be near.
  std::optional<Both> by_sides(const Net& net, const Bends& bent, const Cell& cell) const {
    if (bent.distance() <= fineness_.distance) return std::nullopt;
    const std::array<bool, 4> is_border{cell.u0 == piece_.u0, cell.u1 == piece_.u1, cell.v0 == piece_.v0,
                                        cell.v1 == piece_.v1};
    Both far{0.0, 0.0};
    for (int side = 0; side < 4; ++side) {
      if (!is_border[side]) continue;
      double& along = side < 2 ? far.v : far.u;
      along = std::max(along, side_distance(net, side));
    }
    return std::max(far.u, far.v) > fineness_.distance ? std::optional(far) : std::nullopt;
  }

  std::optional<Both> by_angle(const Look& look, const Cell& cell) const {
    if (fineness_.angle == HUGE_VAL) return std::nullopt;
    const Turns turned = look.turns();
    const Both needed{cell.u1 - cell.u0 > kSmallestTurn ? turned.u : 0.0,
                      cell.v1 - cell.v0 > kSmallestTurn ? turned.v : 0.0};
    if (turned.all <= fineness_.angle || std::max(needed.u, needed.v) <= 0.0) return std::nullopt;
    return needed;
  }

  /// Neither much too long, but for the triangles around a pole, nor bowed like a sickle.
  static std::optional<Both> by_form(const Look& look) {
    constexpr double kPoint = 1e-9;
    const auto [short_u, u] = look.lengths(Axis::u);
    const auto [short_v, v] = look.lengths(Axis::v);
    const bool is_long_u = u > kLongest * v && short_v > kPoint * v;
    const bool is_long_v = v > kLongest * u && short_u > kPoint * u;
    const bool is_along_u = v > 0.0 && (is_long_u || look.sagitta(Axis::u) > kDeepest * v);
    const bool is_along_v = u > 0.0 && (is_long_v || look.sagitta(Axis::v) > kDeepest * u);
    if (!is_along_u && !is_along_v) return std::nullopt;
    return Both{is_along_u ? u : 0.0, is_along_v ? v : 0.0};
  }

  const Fineness& fineness_;
  Probe probe_;
  std::array<Place, 2> widest_;
  Cell piece_;
  std::vector<Cell>& cells_;
};

}  // namespace

std::vector<Cell> cells_of(const NurbsPatch& patch, const std::array<std::vector<MeshSpan>, 2>& spans,
                           const Cell& whole, const Fineness& fineness, bool closed_u, bool closed_v) {
  const BezierGrid grid = to_bezier(patch);
  std::vector<Cell> cells;
  const auto widest = [](Place length, bool closed) { return closed ? length / 3 : length; };
  Splitter splitter(fineness, Probe(patch.knot_vector(Axis::u).degree(), patch.knot_vector(Axis::v).degree()),
                    {widest(whole.u1 - whole.u0, closed_u), widest(whole.v1 - whole.v0, closed_v)}, cells);
  for (Place i = whole.u0 / kSpan; i < whole.u1 / kSpan; ++i) {
    for (Place j = whole.v0 / kSpan; j < whole.v1 / kSpan; ++j) {
      const int number = spans[0][i].number * grid.count_v + spans[1][j].number;
      const BezierPatch& piece = grid.patches[static_cast<std::size_t>(number)];
      splitter.add_piece(net_of(piece), {i * kSpan, (i + 1) * kSpan, j * kSpan, (j + 1) * kSpan});
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
  constexpr std::size_t kSteps = 200;
  breathe(kSteps);
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
  breathe(kStepsOfCell);
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
  require_room(cells_);
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
