#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "base/placement.hpp"
#include "nine_places.hpp"
#include "patch/bezier_piece.hpp"
#include "second_derivatives.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMaxCells = std::size_t{1} << 21;
/// A cell is no longer than this many times its width.
constexpr double kLongest = 16.0;
/// A line along a cell bows by no more than this part of the width, so that faces neither fold nor become slivers.
constexpr double kDeepest = 0.125;
/// Cells this small are not split any more: 2^-22 of a span.
constexpr Place kSmallest = kSpan >> 22;
/// And these not for their normals, which turn at once where a surface folds, nor for their form.
constexpr Place kSmallestTurn = kSpan >> 10;

/// Something along u and along v.
struct Both {
  double u;
  double v;
};

class Splitter {
 public:
  /// @param widest  no cell is wider
  /// @param count   of cells, of whoever else counts there, too
  Splitter(const Fineness& fineness, const PieceBounds& bounds, const NinePlaces& places,
           const std::array<Place, 2>& widest, std::atomic<std::size_t>& count, std::vector<Cut>& cuts)
      : fineness_(fineness), bounds_(bounds), places_(places), widest_(widest), count_(count), cuts_(cuts) {}

  /// Cuts the rectangle that a piece fills.
  void add_piece(BernsteinNet<glm::dvec4> net, const MeshCell& cell) {
    piece_ = cell;
    nets_.front() = std::move(net);
    add(0, cell);
  }

 private:
  /// Cuts a rectangle whose piece lies in a place of nets_, and uses those behind it.
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
      cuts_.push_back(*axis == Axis::u ? Cut::across_u : Cut::across_v);
      add(depth + 1, first);
    }
    require_room_for_cells(count_.fetch_add(1, std::memory_order_relaxed));
    cuts_.push_back(Cut::none);
  }

  std::optional<Axis> axis_to_split(const BernsteinNet<glm::dvec4>& net, const MeshCell& cell) {
    if (cell.u1 - cell.u0 > widest_[0]) return Axis::u;
    if (cell.v1 - cell.v0 > widest_[1]) return Axis::v;
    const bool can_u = cell.u1 - cell.u0 > kSmallest;
    const bool can_v = cell.v1 - cell.v0 > kSmallest;
    const bool is_wide = cell.u1 - cell.u0 >= cell.v1 - cell.v0;
    bounds_.take(net);
    places_.take(net);
    const SecondDerivativeBounds bounds = bounds_.bounds();
    if (bounds.distance() == HUGE_VAL) {
      if (!can_u && !can_v) throw InvalidShape("the patch runs to infinity: no mesh is near it everywhere");
      return can_u && (!can_v || is_wide) ? Axis::u : Axis::v;
    }
    if (!can_u && !can_v) return std::nullopt;
    const auto needed = need_of(bounds, cell);
    if (!needed) return std::nullopt;
    const bool is_u = needed->u == needed->v ? is_wide : needed->u > needed->v;
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
    return by_form(cell);
  }

  /// How much each direction adds to the distance from a face, where that is too large.
  ///
  /// A point of the piece lies off the plane of its face by as much as its height bends. In that plane it lies off the
  /// place of its parameters, and perhaps over a face beside it, whose plane falls away by the angle between them.
  std::optional<Both> by_distance(const SecondDerivativeBounds& bounds) {
    const glm::dvec3 normal = places_.middle_normal();
    if (normal == glm::dvec3(0.0)) return Both{bounds.uu + bounds.uv, bounds.vv + bounds.uv};
    const SecondDerivativeBounds height = bounds_.bounds_along(normal);
    const Both across{height.uu + height.uv, height.vv + height.uv};
    const Both along{bounds.uu + bounds.uv, bounds.vv + bounds.uv};
    // Where both ask for the same direction it does not matter how much the plane falls away.
    const bool is_clear = (across.u > across.v) == (along.u > along.v) && (across.u < across.v) == (along.u < along.v);
    if (is_clear && height.distance() > fineness_.distance) return across;
    if (height.distance() + places_.sine_bound(bounds) * bounds.distance() <= fineness_.distance) return std::nullopt;
    const double fall = places_.largest_sine();
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
      along = std::max(along, bounds_.side_distance(side));
    }
    return std::max(far.u, far.v) > fineness_.distance ? std::optional(far) : std::nullopt;
  }

  std::optional<Both> by_angle(const MeshCell& cell) {
    if (fineness_.angle == HUGE_VAL) return std::nullopt;
    const NormalAngles angles = places_.normal_angles();
    if (angles.all <= fineness_.angle) return std::nullopt;
    // No two normals are farther apart than along u and then along v: one of the two is half of the angle at least.
    const auto part = [&](Axis axis, double angle, Place width) {
      const bool counts = angle > 0.5 * fineness_.angle && width > kSmallestTurn;
      return counts && !(places_.longest(axis) < fineness_.smallest) ? angle : 0.0;
    };
    const Both needed{part(Axis::u, angles.u, cell.u1 - cell.u0), part(Axis::v, angles.v, cell.v1 - cell.v0)};
    return std::max(needed.u, needed.v) > 0.0 ? std::optional(needed) : std::nullopt;
  }

  /// Neither much too long, but for the triangles around a pole, nor bowed like a sickle. A pole inside a cell is
  /// inside one that is as long, however often that is cut.
  std::optional<Both> by_form(const MeshCell& cell) {
    constexpr double kPoint = 1e-9;
    const bool can_u = cell.u1 - cell.u0 > kSmallestTurn;
    const bool can_v = cell.v1 - cell.v0 > kSmallestTurn;
    const auto [short_u, u] = places_.lengths(Axis::u);
    const auto [short_v, v] = places_.lengths(Axis::v);
    const bool is_long_u = u > kLongest * v && short_v > kPoint * v;
    const bool is_long_v = v > kLongest * u && short_u > kPoint * u;
    const bool is_along_u = can_u && v > 0.0 && (is_long_u || places_.sagitta(Axis::u) > kDeepest * v);
    const bool is_along_v = can_v && u > 0.0 && (is_long_v || places_.sagitta(Axis::v) > kDeepest * u);
    if (!is_along_u && !is_along_v) return std::nullopt;
    return Both{is_along_u ? u : 0.0, is_along_v ? v : 0.0};
  }

  Fineness fineness_;
  PieceBounds bounds_;
  NinePlaces places_;
  std::array<Place, 2> widest_;
  MeshCell piece_;
  std::atomic<std::size_t>& count_;
  std::vector<Cut>& cuts_;
  std::deque<BernsteinNet<glm::dvec4>> nets_{1};
};

/// Where a patch is seen: near the origin, and so large that squares of its lengths are numbers.
Placement placement_for_cells(const NurbsPatch& patch) {
  Placement placement = placement_of(patch.points());
  const double size = extent(patch.points());
  if (size > 0.0 && std::isfinite(size)) placement.exponent = std::ilogb(size);
  return placement;
}

/// The exponent of the largest weight.
int weight_exponent_of(const NurbsPatch& patch) {
  double heaviest = 0.0;
  for (const glm::dvec4& p : patch.homogeneous_points()) heaviest = std::max(heaviest, std::abs(p.w));
  return heaviest > 0.0 ? std::ilogb(heaviest) : 0;
}

/// The piece on two spans, with a weight above 0 in its first corner.
BernsteinNet<glm::dvec4> mesh_piece(const NurbsPatch& patch, int span_u, int span_v, int weight_exponent) {
  BernsteinNet<glm::dvec4> piece = bezier_piece(patch, span_u, span_v);
  const double sign = piece.values.front().w < 0.0 ? -1.0 : 1.0;
  for (glm::dvec4& p : piece.values) {
    if (!patch.rational()) {
      p = {glm::dvec3(as_given(p)), 1.0};
    } else {
      for (int axis = 0; axis < 4; ++axis) p[axis] = sign * std::ldexp(p[axis], -weight_exponent);
    }
  }
  return piece;
}

Place widest(Place length, bool closed) { return closed ? length / 3 : length; }

}  // namespace

void require_room_for_cells(std::size_t count) {
  if (count >= kMaxCells) throw InvalidShape("the mesh would have more than 2^21 cells: allow more");
}

PlacedPatch::PlacedPatch(const NurbsPatch& given, const Fineness& wanted) : patch(given), fineness(wanted) {
  const Placement placement = placement_for_cells(given);
  patch = placed(given, placement);
  fineness.distance = given_size(wanted.distance, -1, placement);
  fineness.smallest = given_size(wanted.smallest, -1, placement);
  weight_exponent = weight_exponent_of(patch);
}

CellCutter::CellCutter(const PlacedPatch& placed, const std::array<std::vector<MeshSpan>, 2>& spans,
                       const MeshCell& whole, bool closed_u, bool closed_v)
    : placed_(placed), spans_(spans), whole_(whole),
      widest_{widest(whole.u1 - whole.u0, closed_u), widest(whole.v1 - whole.v0, closed_v)} {}

std::vector<Cut> CellCutter::cuts_of_row(std::size_t row) {
  std::vector<Cut> cuts;
  const NurbsPatch& patch = placed_.patch;
  const NinePlaces places(patch.knot_vector(Axis::u).degree(), patch.knot_vector(Axis::v).degree(), patch.rational());
  Splitter splitter(placed_.fineness, PieceBounds(patch.rational()), places, widest_, count_, cuts);
  const Place i = whole_.u0 / kSpan + static_cast<Place>(row);
  for (Place j = whole_.v0 / kSpan; j < whole_.v1 / kSpan; ++j) {
    splitter.add_piece(mesh_piece(patch, spans_[0][i].number, spans_[1][j].number, placed_.weight_exponent),
                       {i * kSpan, (i + 1) * kSpan, j * kSpan, (j + 1) * kSpan});
  }
  return cuts;
}

}  // namespace splinecore
