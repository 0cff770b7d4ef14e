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
#include "patch_part.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

constexpr double kNarrow = 0x1p-50;
/// So narrow parts of a patch that run through infinity have no points but where weights are zero.
constexpr double kNarrowPatchAtInfinity = 0x1p-24;
/// Radians by which tangents, and normals, of parts may differ that are looked at as a line beside a plane.
constexpr double kGentle = 0.25;
/// Parts of this part of the tolerance are points.
constexpr double kSmall = 0.5;
/// A look at how parts lie counts as so many pairs.
constexpr std::size_t kLook = 16;
constexpr std::size_t kMostPairs = std::size_t{1} << 20;

double held(double t, const Interval& range) { return std::clamp(t, range.start, range.end); }

std::array<double, 2> held(const std::array<double, 2>& at, const std::array<Interval, 2>& range) {
  return {held(at[0], range[0]), held(at[1], range[1])};
}

/// The nearest place of a part of a piece whose normals hardly differ to a point, with its borders.
PatchSpot foot_in(const PatchPieces& patch, PatchSpot at, const std::array<Interval, 2>& range, const glm::dvec3& point) {
  constexpr int kMost = 12;
  for (int round = 0; round < kMost; ++round) {
    breathe(128);
    const Slopes<2> s = patch.at(at, point);
    const double uu = glm::dot(s.first[0], s.first[0]);
    const double uv = glm::dot(s.first[0], s.first[1]);
    const double vv = glm::dot(s.first[1], s.first[1]);
    const double u = -glm::dot(s.offset, s.first[0]);
    const double v = -glm::dot(s.offset, s.first[1]);
    const double determinant = uu * vv - uv * uv;
    std::array<double, 2> next = at.at;
    constexpr double kParallel = 0x1p-40;
    constexpr double kPoint = 0x1p-80;
    if (determinant > kParallel * uu * vv && std::min(uu, vv) > kPoint * std::max(uu, vv)) {
      next = {at.at[0] + (u * vv - v * uv) / determinant, at.at[1] + (v * uu - u * uv) / determinant};
    } else if (std::max(uu, vv) > 0.0) {
      // Where the patch is but a line it goes along that.
      (uu >= vv ? next[0] : next[1]) += uu >= vv ? u / uu : v / vv;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      // On a border the other parameter goes on alone.
      if (next[k] >= range[k].start && next[k] <= range[k].end) continue;
      next[k] = held(next[k], range[k]);
      const std::size_t other = 1 - k;
      const double square = k == 0 ? vv : uu;
      const double moved = next[k] - at.at[k];
      if (square > 0.0) next[other] = at.at[other] + ((k == 0 ? v : u) - moved * uv) / square;
    }
    next = held(next, range);
    const double step = std::max(std::abs(next[0] - at.at[0]), std::abs(next[1] - at.at[1]));
    at.at = next;
    if (step <= 0x1p-50) break;
  }
  return at;
}

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
      pair(CurvePart(i, {}, shapes_.curve.piece(i)), PatchPart(j, {}, shapes_.patch.piece(j)));
    });
    return std::move(found_);
  }

 private:
  static bool is_lost(const CurvePart& part) {
    return !part.is_boxed && (part.range.length() <= kNarrow || is_far_out(part));
  }
  static bool is_lost(const PatchPart& part) {
    return !part.is_boxed && std::max(part.range[0].length(), part.range[1].length()) <= kNarrowPatchAtInfinity;
  }

  void pair(const CurvePart& curve, const PatchPart& patch) {
    breathe(32 * (curve.net.rows + patch.net.values.size()));
    if (++pairs_ > kMostPairs) {
      throw InvalidShape("more than " + std::to_string(kMostPairs) +
                         " pairs of parts are within the tolerance: "
                         "the curve lies on too much of the patch, or it is too small");
    }
    if (is_lost(curve) || is_lost(patch) || are_parts_apart(curve, patch)) return;
    if (goes_through(curve, patch) && cross(curve, patch)) return;
    const bool are_boxed = curve.is_boxed && patch.is_boxed;
    const bool are_gentle = are_boxed && std::max(curve.spread, patch.normals().spread) <= kGentle;
    const Lying lying = are_gentle ? how_lies(curve, patch) : Lying::off;
    if (lying == Lying::on) return add(curve, patch);
    if (lying == Lying::begins && is_behind(curve, patch, false)) return;
    if (lying == Lying::ends && is_behind(curve, patch, true)) return;
    const bool is_small = are_boxed && std::max(curve.size, patch.largest_size()) <= kSmall * tolerance_;
    if (is_small || curve.range.length() <= kNarrow) return add(curve, patch);
    const bool is_larger = curve.is_boxed == patch.is_boxed ? curve.size >= patch.largest_size() : !curve.is_boxed;
    if (is_larger || lying == Lying::leaves) {
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
    if (patch.normals().spread <= kGentle) return longer;
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
    PierceSpot at{{curve.piece, held(through->curve.t, curve.range)},
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

  /// How a part lies beside a part of a patch.
  enum class Lying {
    on,      ///< so many places are within the tolerance of it that the part is one with it
    leaves,  ///< so it does where it is not beside its borders
    begins,  ///< it is near where it begins, and else beside its borders
    ends,    ///< likewise where it ends
    off
  };

  Lying how_lies(const CurvePart& curve, const PatchPart& patch) {
    constexpr std::size_t kMost = 33;
    const std::size_t count = std::min(curve.net.rows * (patch.net.rows + patch.net.columns), kMost);
    pairs_ += kLook;
    PatchSpot foot{patch.piece, patch.middle()};
    std::size_t near = 0;
    bool is_inside = false;
    bool begins = false;
    bool ends = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = curve.range.start + curve.range.length() * static_cast<double>(i) / static_cast<double>(count - 1);
      const glm::dvec3 point = shapes_.curve.at({curve.piece, t}).point;
      foot = foot_in(shapes_.patch, foot, patch.range, point);
      const bool is_near = glm::length(shapes_.patch.at(foot, point).offset) <= tolerance_;
      const bool is_held = held_at_border(foot, patch.range);
      if (!is_near && !is_held) return Lying::off;
      near += is_near ? 1 : 0;
      begins = begins || (is_near && i == 0);
      ends = ends || (is_near && i + 1 == count);
      is_inside = is_inside || !is_held;
    }
    if (near == count) return Lying::on;
    if (near == 1 && (begins || ends)) return begins ? Lying::begins : Lying::ends;
    return is_inside ? Lying::leaves : Lying::off;
  }

  /// Of a part that begins, or ends, on the border of a patch and leaves it there adds what is near. @returns false if it
  /// is not known that the rest is not
  bool is_behind(const CurvePart& curve, const PatchPart& patch, bool at_end) {
    constexpr int kHalvings = 50;
    const double end = at_end ? curve.range.end : curve.range.start;
    const auto foot_at = [&](double t, const PatchSpot& from) {
      return foot_in(shapes_.patch, from, patch.range, shapes_.curve.at({curve.piece, t}).point);
    };
    const PatchSpot first = foot_at(end, {patch.piece, patch.middle()});
    const auto parted = [&](double distance) {
      Interval parts{end, at_end ? curve.range.start : curve.range.end};  // near, and farther than that
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (parts.start + parts.end);
        const PierceSpot at{{curve.piece, middle}, foot_at(middle, first)};
        (shapes_.distance(at) <= distance ? parts.start : parts.end) = middle;
      }
      return parts;
    };
    const double far = parted(2.0 * tolerance_).end;
    const PierceSpot there{{curve.piece, far}, foot_at(far, first)};
    const double share = (far - curve.range.start) / curve.range.length();
    BernsteinNet<glm::dvec4> before = curve.net;
    BernsteinNet<glm::dvec4> behind;
    before.cut(Axis::u, share, behind);
    const CurvePart rest = at_end ? CurvePart(curve.piece, {curve.range.start, far}, std::move(before))
                                  : CurvePart(curve.piece, {far, curve.range.end}, std::move(behind));
    if (!rest.is_boxed || !are_apart_by(rest, patch, there)) return false;
    const double near = parted(tolerance_).start;
    found_.stretches.push_back({curve.piece, {std::min(end, near), std::max(end, near)}, first});
    return true;
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

double CurveAndPatch::distance(const PierceSpot& at) const noexcept {
  return glm::length(patch.at(at.patch, curve.at(at.curve).point).offset);
}

std::optional<PierceSpot> pierced(const CurveAndPatch& shapes, PierceSpot at) {
  constexpr int kMost = 24;
  constexpr double kBeyond = 2.0;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kMost; ++round) {
    breathe(128);
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

PatchSpot patch_foot(const PatchPieces& patch, PatchSpot at, const glm::dvec3& point) {
  constexpr int kMostHops = 16;
  const std::array<Interval, 2> whole{};
  at = foot_in(patch, at, whole, point);
  double least = glm::length(patch.at(at, point).offset);
  for (int hops = 0; hops < kMostHops; ++hops) {
    PatchSpot best = at;
    for (const Axis axis : {Axis::u, Axis::v}) {
      const std::size_t k = axis == Axis::u ? 0 : 1;
      if (at.at[k] != 0.0 && at.at[k] != 1.0) continue;
      const auto next = patch.beyond(at.piece, {axis, at.at[k] == 1.0});
      if (!next) continue;
      PatchSpot there{*next, at.at};
      there.at[k] = 1.0 - at.at[k];
      there = foot_in(patch, there, whole, point);
      const double distance = glm::length(patch.at(there, point).offset);
      if (distance < least) {
        least = distance;
        best = there;
      }
    }
    if (best.piece == at.piece) break;
    at = best;
  }
  return at;
}

PiercePairFindings find_pairs(const CurveAndPatch& shapes, double tolerance) {
  return PierceSearch(shapes, tolerance).found();
}

}  // namespace splinecore
