#include "curve_patch_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>

#include "curve_approach.hpp"
#include "curve_part.hpp"
#include "hull_extent.hpp"
#include "patch_foot.hpp"
#include "patch_part.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

constexpr double kNarrowCurve = 0x1p-50;
/// So narrow parts of a patch that run through infinity have no points but where weights are zero.
constexpr double kNarrowPatchAtInfinity = 0x1p-24;
/// Radians by which tangents, and normals, of parts may differ that are looked at as a line beside a plane.
constexpr double kGentleTurn = 0.25;
/// Parts of so many tolerances are points: what a finding is is measured where it is.
constexpr double kSmallParts = 2.0;
/// A look at how parts lie counts as so many pairs.
constexpr std::size_t kLook = 16;
constexpr std::size_t kMostCurvePatchPairs = std::size_t{1} << 20;

/// How much the directions of the legs of a net turn from one to the next, along u and along v.
std::array<double, 2> turns_along(const PatchPart& patch) {
  const std::size_t rows = patch.net.rows;
  const std::size_t columns = patch.net.columns;
  std::array<double, 2> turns{0.0, 0.0};
  const auto leg = [&](std::size_t i, std::size_t j, Axis axis) {
    const std::size_t k = i * columns + j;
    const glm::dvec3 way = patch.points[k + (axis == Axis::u ? columns : 1)] - patch.points[k];
    const double length = glm::length(way);
    return length > 0.0 ? way / length : way;
  };
  for (const Axis axis : {Axis::u, Axis::v}) {
    const std::size_t last_row = axis == Axis::u ? rows - 1 : rows;
    const std::size_t last_column = axis == Axis::v ? columns - 1 : columns;
    for (std::size_t i = 0; i < last_row; ++i) {
      for (std::size_t j = 0; j < last_column; ++j) {
        const glm::dvec3 here = leg(i, j, axis);
        const auto turn_to = [&](const glm::dvec3& next) {
          const bool are_ways = glm::dot(here, here) > 0.0 && glm::dot(next, next) > 0.0;
          return are_ways ? glm::distance(here, next) : 0.0;
        };
        if (i + 1 < last_row) turns[0] = std::max(turns[0], turn_to(leg(i + 1, j, axis)));
        if (j + 1 < last_column) turns[1] = std::max(turns[1], turn_to(leg(i, j + 1, axis)));
      }
    }
  }
  return turns;
}

/// Whether homogeneous points that run through infinity are apart from a hull, as seen along an axis of coordinates.
bool is_outside(std::span<const glm::dvec4> through, std::span<const glm::dvec3> hull, double distance) {
  const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  return std::ranges::any_of(axes, [&](const glm::dvec3& axis) {
    const Interval slab = extent_along(hull, axis, glm::dvec3(0.0));
    return is_outside_slab(through, axis, {slab.start - distance, slab.end + distance});
  });
}

class PierceSearch {
 public:
  PierceSearch(const CurveAndPatch& shapes, double tolerance) : shapes_(shapes), tolerance_(tolerance) {}

  PiercePairFindings found() {
    for_near_pairs(shapes_.curve.tree(), shapes_.patch.tree(), tolerance_, [&](std::size_t i, std::size_t j) {
      pair(CurvePart(i, {}, shapes_.curve.piece(i), shapes_.curve.sums(i)), PatchPart(j, {}, shapes_.patch.piece(j)));
    });
    return std::move(found_);
  }

 private:
  static bool is_lost(const CurvePart& part) {
    return !part.is_boxed && (part.range.length() <= kNarrowCurve || is_far_out(part));
  }
  static bool is_lost(const PatchPart& part) {
    return !part.is_boxed && std::max(part.range[0].length(), part.range[1].length()) <= kNarrowPatchAtInfinity;
  }

  void pair(const CurvePart& curve, const PatchPart& patch) {
    breathe(32 * (curve.net.rows + patch.net.values.size()));
    if (++pairs_ > kMostCurvePatchPairs) {
      throw InvalidShape("more than " + std::to_string(kMostCurvePatchPairs) +
                         " pairs of parts are within the tolerance: "
                         "the curve lies on too much of the patch, or it is too small");
    }
    if (is_lost(curve) || is_lost(patch) || are_parts_apart(curve, patch)) return;
    if (goes_through(curve, patch) && cross(curve, patch)) return;
    const bool are_boxed = curve.is_boxed && patch.is_boxed;
    const bool are_gentle = are_boxed && std::max(curve.spread, patch.normals().spread) <= kGentleTurn;
    const Lying lying = are_gentle ? how_lies(curve, patch) : Lying{};
    if (lying.how == Lying::How::on) return add(curve, patch);
    if (lying.how == Lying::How::apart) return;
    if (lying.how == Lying::How::partly && take_part(curve, patch, lying)) return;
    const bool is_small = are_boxed && std::max(curve.size, patch.largest_size()) <= kSmallParts * tolerance_;
    if (is_small || curve.range.length() <= kNarrowCurve) return add(curve, patch);
    const bool is_larger = curve.is_boxed == patch.is_boxed ? curve.size >= patch.largest_size() : !curve.is_boxed;
    if (is_larger || lying.how == Lying::How::leaves) {
      const auto [first, second] = curve.halves();
      pair(first, patch);
      pair(second, patch);
    } else {
      const auto [first, second] = patch.halves(axis_to_halve(patch));
      pair(curve, first);
      pair(curve, second);
    }
  }

  /// Of a part that bends much the axis along which it does, else the longer one.
  static Axis axis_to_halve(const PatchPart& patch) {
    if (!patch.is_boxed) return patch.range[0].length() >= patch.range[1].length() ? Axis::u : Axis::v;
    const Axis longer = patch.size[0] >= patch.size[1] ? Axis::u : Axis::v;
    if (patch.normals().spread <= kGentleTurn) return longer;
    const std::array<double, 2> turns = turns_along(patch);
    constexpr double kEven = 4.0;
    constexpr double kThin = 0.25;
    const bool is_u = turns[0] > kEven * turns[1] && patch.size[0] > kThin * patch.size[1];
    const bool is_v = turns[1] > kEven * turns[0] && patch.size[1] > kThin * patch.size[0];
    return is_u ? Axis::u : is_v ? Axis::v : longer;
  }

  bool are_parts_apart(const CurvePart& curve, const PatchPart& patch) const {
    if (curve.is_boxed && patch.is_boxed) return are_apart(curve, patch, tolerance_);
    if (curve.is_boxed) return is_outside(patch.net.values, curve.points, tolerance_);
    return patch.is_boxed && is_outside(curve.net.values, patch.points, tolerance_);
  }

  bool are_apart_by(const CurvePart& curve, const PatchPart& patch, const PierceSpot& at) const {
    const glm::dvec3 gap = shapes_.patch.at(at.patch, shapes_.curve.at(at.curve).point).offset;
    const double length = glm::length(gap);
    return length > 0.0 && are_apart_along(curve.points, patch.points, std::array{gap / length}, tolerance_);
  }

  /// Finds where a part goes through. @returns false if neither a place nor a gap is found
  bool cross(const CurvePart& curve, const PatchPart& patch) {
    const PierceSpot middle{{curve.piece, curve.range.middle()}, {patch.piece, patch.middle()}};
    const std::optional<PierceSpot> through = pierced(shapes_, middle);
    if (!through) return false;
    PierceSpot at{{curve.piece, std::clamp(through->curve.t, curve.range.start, curve.range.end)},
                  {patch.piece, held(through->patch.at, patch.range)}};
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
      at.patch = foot_in(shapes_.patch, at.patch, patch.range, shapes_.curve.at(at.curve).point);
      if (shapes_.distance(at) <= tolerance_) {
        found_.crossings.push_back(at);
        return true;
      }
      if (are_apart_by(curve, patch, at)) return true;
      at.curve.t = foot_of(shapes_.curve, curve.piece, curve.range, shapes_.patch.at(at.patch).point);
    }
    return false;
  }

  /// How a part lies beside a part of a patch: so many places of it are looked at.
  struct Lying {
    enum class How {
      on,      ///< all are within the tolerance: the part is one with it
      partly,  ///< some are, and the others are beside its borders
      leaves,  ///< none is, and some are not beside its borders
      apart,
      off
    };
    How how = How::off;
    Interval near{};  ///< the first stretch of places that are near, and those next to it
    Interval around{};
    PatchSpot foot{};  ///< of one of them
  };

  PierceSpot with_foot(const CurvePart& curve, double t, const PatchPart& patch, const PatchSpot& from) const {
    const CurveSpot spot{curve.piece, t};
    return {spot, foot_in(shapes_.patch, from, patch.range, shapes_.curve.at(spot).point)};
  }

  Lying how_lies(const CurvePart& curve, const PatchPart& patch) {
    constexpr std::size_t kMost = 33;
    const std::size_t count = std::min(curve.net.rows * (patch.net.rows + patch.net.columns), kMost);
    pairs_ += kLook;
    Lying lying;
    PierceSpot at{{curve.piece, curve.range.start}, {patch.piece, patch.middle()}};
    PierceSpot nearest = at;
    double least = std::numeric_limits<double>::infinity();
    double before = curve.range.start;
    std::size_t near = 0;
    bool is_first = true;
    bool is_inside = false;
    bool is_off = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = i + 1 == count ? curve.range.end
                                      : curve.range.start + curve.range.length() * static_cast<double>(i) /
                                                                static_cast<double>(count - 1);
      at = with_foot(curve, t, patch, at.patch);
      const double distance = shapes_.distance(at);
      const bool is_held = held_at_border(at.patch, patch.range);
      const bool is_near = distance <= tolerance_;
      if (distance < least) nearest = at;
      least = std::min(least, distance);
      if (is_near && near == 0) lying = {Lying::How::off, {t, t}, {before, t}, at.patch};
      if (is_near && is_first) lying.near.end = t;
      if (is_near && is_first) lying.around.end = t;
      if (!is_near && near > 0 && is_first) {
        lying.around.end = t;
        is_first = false;
      }
      near += is_near ? 1 : 0;
      is_inside = is_inside || !is_held;
      is_off = is_off || (!is_near && !is_held);
      before = t;
      if (is_off && near > 0) break;
    }
    if (near == count) {
      lying.how = Lying::How::on;
    } else if (near > 0) {
      lying.how = is_off ? Lying::How::off : Lying::How::partly;
    } else if (are_apart_by(curve, patch, nearest)) {
      lying.how = Lying::How::apart;
    } else if (is_inside && !is_off) {
      lying.how = Lying::How::leaves;
    }
    return lying;
  }

  /// From a place that is near to one that is not: the last one that is, and the first that is so much farther away that
  /// what follows may be known to be apart.
  Interval parted(const CurvePart& curve, const PatchPart& patch, const Lying& lying, double near, double far) const {
    constexpr int kHalvings = 50;
    constexpr double kFine = 0x1p-4;
    constexpr double kClear = 1.5;
    const auto point = [&](double t) { return shapes_.curve.at({curve.piece, t}).point; };
    const auto distance = [&](double t) { return shapes_.distance(with_foot(curve, t, patch, lying.foot)); };
    const double last = far;
    for (int i = 0; i < kHalvings && glm::distance(point(near), point(far)) > kFine * tolerance_; ++i) {
      const double middle = 0.5 * (near + far);
      (distance(middle) <= tolerance_ ? near : far) = middle;
    }
    double step = far - near;
    while (std::abs(far - near) < std::abs(last - near) && distance(far) < kClear * tolerance_) {
      far += step;
      step *= 2.0;
    }
    return {near, std::abs(far - near) < std::abs(last - near) ? far : last};
  }

  /// Of a part that lies on a patch, and goes on over its borders, adds the first stretch and looks at the rest. @returns
  /// false where it is not so
  bool take_part(const CurvePart& curve, const PatchPart& patch, const Lying& lying) {
    const Interval& in = curve.range;
    const bool begins = lying.near.start == in.start;
    const bool ends = lying.near.end == in.end;
    const Interval before = begins ? Interval{in.start, in.start}
                                   : parted(curve, patch, lying, lying.near.start, lying.around.start);
    const Interval behind = ends ? Interval{in.end, in.end}
                                 : parted(curve, patch, lying, lying.near.end, lying.around.end);
    constexpr int kPlaces = 16;
    const Interval own{before.start, behind.start};
    PierceSpot at{{curve.piece, own.start}, lying.foot};
    for (int i = 0; i <= kPlaces; ++i) {
      at = with_foot(curve, own.start + own.length() * i / kPlaces, patch, at.patch);
      if (!(shapes_.distance(at) <= tolerance_)) return false;
    }
    found_.stretches.push_back({curve.piece, own, lying.foot});
    if (!begins) pair(part_of(curve, {in.start, before.end}), patch);
    if (!ends) pair(part_of(curve, {behind.end, in.end}), patch);
    return true;
  }

  /// Of a part what is before or behind a place.
  static CurvePart part_of(const CurvePart& curve, const Interval& range) {
    const bool is_start = range.start == curve.range.start;
    const double t = is_start ? range.end : range.start;
    BernsteinNet<glm::dvec4> before = curve.net;
    BernsteinNet<glm::dvec4> behind;
    before.cut(Axis::u, (t - curve.range.start) / curve.range.length(), behind);
    return CurvePart(curve.piece, range, std::move(is_start ? before : behind));
  }

  static bool held_at_border(const PatchSpot& foot, const std::array<Interval, 2>& range) {
    const auto is_end = [](double t, const Interval& in) { return t == in.start || t == in.end; };
    return is_end(foot.at[0], range[0]) || is_end(foot.at[1], range[1]);
  }

  void add(const CurvePart& curve, const PatchPart& patch) {
    const glm::dvec3 point = shapes_.curve.at({curve.piece, curve.range.middle()}).point;
    const PatchSpot foot = foot_in(shapes_.patch, {patch.piece, patch.middle()}, patch.range, point);
    found_.stretches.push_back({curve.piece, curve.range, foot});
  }

  CurveAndPatch shapes_;
  double tolerance_;
  std::size_t pairs_ = 0;
  PiercePairFindings found_;
};

}  // namespace

double CurveAndPatch::distance(const PierceSpot& at) const {
  return glm::length(patch.at(at.patch, curve.at(at.curve).point).offset);
}

std::optional<PierceSpot> pierced(const CurveAndPatch& shapes, PierceSpot at) {
  constexpr int kMost = 24;
  constexpr double kBeyond = 2.0;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    const Slopes<1> c = shapes.curve.at(at.curve);
    const Slopes<2> s = shapes.patch.at(at.patch, c.point);
    const glm::dvec3 normal = glm::cross(s.first[0], s.first[1]);
    const double volume = glm::dot(c.first[0], normal);
    if (!(std::abs(volume) > 0.0)) return {};
    const double t = glm::dot(s.offset, normal) / volume;
    const double u = glm::dot(c.first[0], glm::cross(s.first[1], s.offset)) / volume;
    const double v = glm::dot(c.first[0], glm::cross(s.offset, s.first[0])) / volume;
    at.curve.t += t;
    at.patch.at[0] += u;
    at.patch.at[1] += v;
    const double most = std::max({std::abs(t), std::abs(u), std::abs(v)});
    const double out = std::max({std::abs(at.curve.t), std::abs(at.patch.at[0]), std::abs(at.patch.at[1])});
    if (!(out <= 1.0 + kBeyond)) return {};
    if (most <= 0x1p-50 || (most < 0x1p-30 && most >= 0.5 * before)) return at;
    before = most;
  }
  return {};
}

PiercePairFindings find_pairs(const CurveAndPatch& shapes, double tolerance) {
  return PierceSearch(shapes, tolerance).found();
}

}  // namespace splinecore
