#include "splinecore/tessellate/cells.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/tessellate/flatness.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMaxCells = std::size_t{1} << 21;
/// What a cell costs, about, in steps of breathe().
constexpr std::size_t kStepsOfCell = 500;
/// A cell is no longer than this many times its width.
constexpr double kLongest = 16.0;
/// A line along a cell bows by no more than this part of the width, so that faces neither fold nor become slivers.
constexpr double kDeepest = 0.125;
/// Cells this small are not split any more: 2^-22 of a span.
constexpr Place kSmallest = kSpan >> 22;
/// And these not for their normals, which turn at once where a surface folds.
constexpr Place kSmallestTurn = kSpan >> 10;

/// @throws InvalidShape if there are as many cells as there may be.
void require_room(const std::vector<MeshCell>& cells) {
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
  Splitter(const Fineness& fineness, FlatnessProbe probe, const std::array<Place, 2>& widest,
           std::vector<MeshCell>& cells)
      : fineness_(fineness), probe_(std::move(probe)), widest_(widest), cells_(cells) {}

  /// Tiles the cell that a piece fills.
  void add_piece(BernsteinNet<glm::dvec4> net, const MeshCell& cell) {
    piece_ = cell;
    nets_.front() = std::move(net);
    add(0, cell);
  }

 private:
  /// Tiles a cell whose piece lies in a place of nets_, and uses those behind it.
  void add(std::size_t depth, MeshCell cell) {
    if (nets_.size() == depth + 1) nets_.emplace_back();
    BernsteinNet<glm::dvec4>& net = nets_[depth];
    while (true) {
      breathe(kStepsOfCell + 2 * net.values.size() * (net.rows + net.columns));
      const auto axis = axis_to_split(net, cell);
      if (!axis) break;
      nets_[depth + 1] = net;
      nets_[depth + 1].halve(*axis, net);
      MeshCell first = cell;
      if (*axis == Axis::u) {
        first.u1 = cell.u0 = (cell.u0 + cell.u1) / 2;
      } else {
        first.v1 = cell.v0 = (cell.v0 + cell.v1) / 2;
      }
      add(depth + 1, first);
    }
    require_room(cells_);
    cells_.push_back(cell);
  }

  std::optional<Axis> axis_to_split(const BernsteinNet<glm::dvec4>& net, const MeshCell& cell) {
    if (cell.u1 - cell.u0 > widest_[0]) return Axis::u;
    if (cell.v1 - cell.v0 > widest_[1]) return Axis::v;
    const bool can_u = cell.u1 - cell.u0 > kSmallest;
    const bool can_v = cell.v1 - cell.v0 > kSmallest;
    probe_.take(net);
    const SecondDerivativeBounds bounds = probe_.bounds();
    if (bounds.distance() == HUGE_VAL) {
      if (!can_u && !can_v) throw InvalidShape("the patch runs to infinity: no mesh is near it everywhere");
      return can_u && (!can_v || cell.u1 - cell.u0 >= cell.v1 - cell.v0) ? Axis::u : Axis::v;
    }
    if (!can_u && !can_v) return std::nullopt;
    const auto needed = need_of(bounds, cell);
    if (!needed) return std::nullopt;
    const bool is_u = needed->u >= needed->v;
    if (is_u ? can_u : can_v) return is_u ? Axis::u : Axis::v;
    return can_u ? Axis::u : Axis::v;
  }

  /// The first reason to split, cheap ones before.
  std::optional<Both> need_of(const SecondDerivativeBounds& bounds, const MeshCell& cell) {
    if (bounds.distance() > fineness_.distance) {
      if (const auto needed = by_distance(bounds)) return needed;
      if (const auto needed = by_sides(cell)) return needed;
    }
    if (const auto needed = by_angle(cell)) return needed;
    return by_form();
  }

  /// How much each direction adds to the distance from a face, where that is too large.
  ///
  /// A point of the piece lies off the plane of its face by as much as its height bends. In that plane it lies off the
  /// place of its parameters, and perhaps over a face beside it, whose plane falls away by the angle between them.
  std::optional<Both> by_distance(const SecondDerivativeBounds& bounds) {
    const glm::dvec3 normal = probe_.middle_normal();
    if (normal == glm::dvec3(0.0)) return Both{bounds.uu + bounds.uv, bounds.vv + bounds.uv};
    const SecondDerivativeBounds height = probe_.bounds_along(normal);
    const Both across{height.uu + height.uv, height.vv + height.uv};
    const Both along{bounds.uu + bounds.uv, bounds.vv + bounds.uv};
    // Where both ask for the same direction it does not matter how much the plane falls away.
    const bool is_clear = (across.u > across.v) == (along.u > along.v) && (across.u < across.v) == (along.u < along.v);
    if (is_clear && height.distance() > fineness_.distance) return across;
    const double fall = probe_.largest_sine();
    if (height.distance() + fall * bounds.distance() <= fineness_.distance) return std::nullopt;
    return Both{across.u + fall * along.u, across.v + fall * along.v};
  }

  /// On the border of a piece, where the next one may go on in any direction, the line itself must be near.
  std::optional<Both> by_sides(const MeshCell& cell) {
    const std::array<bool, 4> is_border{cell.u0 == piece_.u0, cell.u1 == piece_.u1, cell.v0 == piece_.v0,
                                        cell.v1 == piece_.v1};
    Both far{0.0, 0.0};
    for (int side = 0; side < 4; ++side) {
      if (!is_border[side]) continue;
      double& along = side < 2 ? far.v : far.u;
      along = std::max(along, probe_.side_distance(side));
    }
    return std::max(far.u, far.v) > fineness_.distance ? std::optional(far) : std::nullopt;
  }

  std::optional<Both> by_angle(const MeshCell& cell) {
    if (fineness_.angle == HUGE_VAL) return std::nullopt;
    const NormalAngles angles = probe_.normal_angles();
    const Both needed{cell.u1 - cell.u0 > kSmallestTurn ? angles.u : 0.0,
                      cell.v1 - cell.v0 > kSmallestTurn ? angles.v : 0.0};
    if (angles.all <= fineness_.angle || std::max(needed.u, needed.v) <= 0.0) return std::nullopt;
    return needed;
  }

  /// Neither much too long, but for the triangles around a pole, nor bowed like a sickle.
  std::optional<Both> by_form() {
    constexpr double kPoint = 1e-9;
    const auto [short_u, u] = probe_.lengths(Axis::u);
    const auto [short_v, v] = probe_.lengths(Axis::v);
    const bool is_long_u = u > kLongest * v && short_v > kPoint * v;
    const bool is_long_v = v > kLongest * u && short_u > kPoint * u;
    const bool is_along_u = v > 0.0 && (is_long_u || probe_.sagitta(Axis::u) > kDeepest * v);
    const bool is_along_v = u > 0.0 && (is_long_v || probe_.sagitta(Axis::v) > kDeepest * u);
    if (!is_along_u && !is_along_v) return std::nullopt;
    return Both{is_along_u ? u : 0.0, is_along_v ? v : 0.0};
  }

  Fineness fineness_;
  FlatnessProbe probe_;
  std::array<Place, 2> widest_;
  MeshCell piece_;
  std::vector<MeshCell>& cells_;
  std::deque<BernsteinNet<glm::dvec4>> nets_{1};
};

/// Powers of two that bring coordinates and weights of a patch near 1, so that squares of lengths are numbers.
struct Scale {
  int points = 0;
  int weights = 0;
};

Scale scale_of(const NurbsPatch& patch) {
  double largest = 0.0;
  double heaviest = 0.0;
  for (const glm::dvec4& p : patch.homogeneous_points()) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    heaviest = std::max(heaviest, std::abs(p.w));
  }
  const int weights = std::ilogb(heaviest);
  return {largest > 0.0 && std::isfinite(largest) ? std::ilogb(largest) : weights, weights};
}

/// The piece on two spans, scaled, with a weight above 0 in its first corner.
BernsteinNet<glm::dvec4> mesh_piece(const NurbsPatch& patch, int span_u, int span_v, const Scale& scale) {
  BernsteinNet<glm::dvec4> piece = bezier_piece(patch, span_u, span_v);
  const double sign = piece.values.front().w < 0.0 ? -1.0 : 1.0;
  for (glm::dvec4& p : piece.values) {
    if (!patch.rational()) p = {glm::dvec3(as_given(p)), 1.0};
    for (int axis = 0; axis < 3; ++axis) p[axis] = sign * std::ldexp(p[axis], -scale.points);
    p.w = sign * std::ldexp(p.w, -scale.weights);
  }
  return piece;
}

}  // namespace

std::vector<MeshCell> cells_of(const NurbsPatch& patch, const std::array<std::vector<MeshSpan>, 2>& spans,
                               const MeshCell& whole, const Fineness& fineness, bool closed_u, bool closed_v) {
  std::vector<MeshCell> cells;
  const auto widest = [](Place length, bool closed) { return closed ? length / 3 : length; };
  const Scale scale = scale_of(patch);
  const Fineness scaled{std::ldexp(fineness.distance, scale.weights - scale.points), fineness.angle};
  const FlatnessProbe probe(patch.knot_vector(Axis::u).degree(), patch.knot_vector(Axis::v).degree(), patch.rational());
  const std::array<Place, 2> most{widest(whole.u1 - whole.u0, closed_u), widest(whole.v1 - whole.v0, closed_v)};
  Splitter splitter(scaled, probe, most, cells);
  for (Place i = whole.u0 / kSpan; i < whole.u1 / kSpan; ++i) {
    for (Place j = whole.v0 / kSpan; j < whole.v1 / kSpan; ++j) {
      splitter.add_piece(mesh_piece(patch, spans[0][i].number, spans[1][j].number, scale),
                         {i * kSpan, (i + 1) * kSpan, j * kSpan, (j + 1) * kSpan});
    }
  }
  return cells;
}

CellGrid::CellGrid(const MeshCell& whole, std::vector<MeshCell> cells)
    : whole_(whole), cells_(std::move(cells)), is_touched_(cells_.size(), 1),
      vertices_(cells_.size() + cells_.size() / 2) {
  for (std::size_t i = 0; i < cells_.size(); ++i) put_corners(i);
}

/// The number of the side of the rectangle that a line along an axis is, or -1.
int CellGrid::side_on(Axis axis, Place line) const {
  if (axis == Axis::v) return line == whole_.u0 ? 0 : line == whole_.u1 ? 1 : -1;
  return line == whole_.v0 ? 2 : line == whole_.v1 ? 3 : -1;
}

/// A vertex that is this corner of a cell, or with -1 of none; whether it is new.
bool CellGrid::put(Place u, Place v, std::int32_t cell, int corner) {
  constexpr std::size_t kSteps = 50;
  breathe(kSteps);
  const auto [entry, is_new] = vertices_.add(u, v);
  if (corner >= 0) entry.cells[corner] = cell;
  if (!is_new) return false;
  const auto put_on = [&](int side, Place place) {
    if (side >= 0) sides_[side].insert(std::ranges::lower_bound(sides_[side], place), place);
  };
  put_on(side_on(Axis::v, u), v);
  put_on(side_on(Axis::u, v), u);
  return true;
}

void CellGrid::put_corners(std::size_t i) {
  const MeshCell& cell = cells_[i];
  const auto number = static_cast<std::int32_t>(i);
  put(cell.u0, cell.v0, number, 0);
  put(cell.u0, cell.v1, number, 1);
  put(cell.u1, cell.v0, number, 2);
  put(cell.u1, cell.v1, number, -1);
}

/// Touches the cell on a side of the rectangle that has a place inside its own side.
void CellGrid::touch_on_side(int side, Place at) {
  const std::array<Place, 4> lines{whole_.u0, whole_.u1, whole_.v0, whole_.v1};
  const int corner = std::array{0, 2, 0, 1}[side];
  const std::vector<Place>& places = sides_[side];
  for (auto before = std::ranges::lower_bound(places, at); before != places.begin();) {
    --before;
    const PlaceEntry* entry = side < 2 ? vertices_.find(lines[side], *before) : vertices_.find(*before, lines[side]);
    if (entry->cells[corner] >= 0) return touch(entry->cells[corner]);
  }
}

bool CellGrid::add(int side, Place at) {
  const Place line = std::array{whole_.u0, whole_.u1, whole_.v0, whole_.v1}[side];
  if (!(side < 2 ? put(line, at, -1, -1) : put(at, line, -1, -1))) return false;
  touch_on_side(side, at);
  return true;
}

/// Touches the cells beside a line between two places, where their middle has become a vertex: of those as long and of
/// those twice as long. Longer ones had more vertices before.
void CellGrid::touch_beside(Axis axis, Place line, Place from, Place to) {
  for (const Place length : {to - from, 2 * (to - from)}) {
    const Place start = from & ~(length - 1);
    const PlaceEntry* entry = axis == Axis::u ? vertices_.find(start, line) : vertices_.find(line, start);
    if (entry == nullptr) continue;
    touch(entry->cells[0]);
    touch(entry->cells[axis == Axis::u ? 1 : 2]);
  }
}

/// Whether a line has a vertex in the middle of two places.
bool CellGrid::has_middle(Axis axis, Place line, Place from, Place to) const {
  if (to - from < 2) return false;
  const Place middle = (from + to) / 2;
  return (axis == Axis::u ? vertices_.find(middle, line) : vertices_.find(line, middle)) != nullptr;
}

void CellGrid::between(Axis axis, Place line, Place from, Place to, std::vector<Place>& found) const {
  if (const int side = side_on(axis, line); side >= 0) {
    found.insert(found.end(), std::ranges::upper_bound(sides_[side], from), std::ranges::lower_bound(sides_[side], to));
    return;
  }
  if (!has_middle(axis, line, from, to)) return;
  const Place middle = (from + to) / 2;
  between(axis, line, from, middle, found);
  found.push_back(middle);
  between(axis, line, middle, to, found);
}

/// As far as two.
int CellGrid::count_between(Axis axis, Place line, Place from, Place to) const {
  if (const int side = side_on(axis, line); side >= 0) {
    const auto first = std::ranges::upper_bound(sides_[side], from);
    const auto left = static_cast<int>(std::min<std::ptrdiff_t>(sides_[side].end() - first, 2));
    return left > 1 && first[1] < to ? 2 : left > 0 && first[0] < to ? 1 : 0;
  }
  if (!has_middle(axis, line, from, to)) return 0;
  const Place middle = (from + to) / 2;
  return has_middle(axis, line, from, middle) || has_middle(axis, line, middle, to) ? 2 : 1;
}

/// Splits a cell if it must be; whether it was.
bool CellGrid::split(std::size_t i) {
  breathe(kStepsOfCell);
  const MeshCell cell = cells_[i];
  const int low_v = count_between(Axis::u, cell.v0, cell.u0, cell.u1);
  const int high_v = count_between(Axis::u, cell.v1, cell.u0, cell.u1);
  const int low_u = count_between(Axis::v, cell.u0, cell.v0, cell.v1);
  const int high_u = count_between(Axis::v, cell.u1, cell.v0, cell.v1);
  const bool on_all = low_u > 0 && high_u > 0 && low_v > 0 && high_v > 0;
  const bool in_u = std::max(low_v, high_v) > 1 || on_all;
  const bool in_v = !in_u && std::max(low_u, high_u) > 1;
  MeshCell first = cell;
  MeshCell second = cell;
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
  is_touched_.push_back(1);
  put_corners(i);
  put_corners(cells_.size() - 1);
  if (in_u) {
    for (const Place line : {cell.v0, cell.v1}) touch_beside(Axis::u, line, cell.u0, cell.u1);
  } else {
    for (const Place line : {cell.u0, cell.u1}) touch_beside(Axis::v, line, cell.v0, cell.v1);
  }
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
