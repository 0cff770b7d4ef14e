#include "curve_patch_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>

#include "curve_part.hpp"
#include "patch_part.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "tree_pairs.hpp"

namespace splinecore {

namespace {

constexpr double kNarrow = 0x1p-50;
constexpr double kNarrowAtInfinity = 0x1p-14;
constexpr double kNarrowPatchAtInfinity = 0x1p-8;
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
  static bool is_lost(const CurvePart& part) { return !part.is_boxed && part.range.length() <= kNarrowAtInfinity; }
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
    if (is_lost(curve) || is_lost(patch) || are_apart(curve, patch, tolerance_)) return;
    if (goes_through(curve, patch) && cross(curve, patch)) return;
    const bool are_boxed = curve.is_boxed && patch.is_boxed;
    const bool are_gentle = are_boxed && std::max(curve.spread, patch.normals().spread) <= kGentle;
    const Lying lying = are_gentle ? how_lies(curve, patch) : Lying::off;
    if (lying == Lying::on) return add(curve, patch);
    const bool is_small = are_boxed && std::max(curve.size, patch.largest_size()) <= kSmall * tolerance_;
    if (is_small || curve.range.length() <= kNarrow) return add(curve, patch);
    const bool is_larger = curve.is_boxed == patch.is_boxed ? curve.size >= patch.largest_size() : !curve.is_boxed;
    if (is_larger || lying == Lying::leaves) {
      const auto [first, second] = curve.halves();
      pair(first, patch);
      pair(second, patch);
    } else {
      const auto [first, second] = patch.halves();
      pair(curve, first);
      pair(curve, second);
    }
  }

  /// Finds where a part goes through. @returns false if Newton's method does not
  bool cross(const CurvePart& curve, const PatchPart& patch) {
    const PierceSpot middle{{curve.piece, curve.range.middle()}, {patch.piece, patch.middle()}};
    const std::optional<PierceSpot> through = pierced(shapes_, middle);
    if (!through) return false;
    if (is_beyond(*through, curve, patch)) return true;
    PierceSpot at{{curve.piece, held(through->curve.t, curve.range)},
                  {patch.piece, held(through->patch.at, patch.range)}};
    at.patch = foot_in(shapes_.patch, at.patch, patch.range, shapes_.curve.at(at.curve).point);
    if (shapes_.distance(at) <= tolerance_) found_.crossings.push_back(at);
    return true;
  }

  /// Whether a place is one of a part that goes on where one of these ends.
  bool is_beyond(const PierceSpot& at, const CurvePart& curve, const PatchPart& patch) const {
    constexpr double kSame = 0x1p-30;
    const double t = at.curve.t;
    if (t < curve.range.start - kSame && (curve.range.start > 0.0 || shapes_.curve.before(curve.piece))) return true;
    if (t > curve.range.end + kSame && (curve.range.end < 1.0 || shapes_.curve.after(curve.piece))) return true;
    for (const Axis axis : {Axis::u, Axis::v}) {
      const std::size_t k = axis == Axis::u ? 0 : 1;
      const Interval& range = patch.range[k];
      const auto goes_on = [&](bool is_end) { return shapes_.patch.beyond(patch.piece, {axis, is_end}).has_value(); };
      if (at.patch.at[k] < range.start - kSame && (range.start > 0.0 || goes_on(false))) return true;
      if (at.patch.at[k] > range.end + kSame && (range.end < 1.0 || goes_on(true))) return true;
    }
    return false;
  }

  /// How a part lies beside a part of a patch.
  enum class Lying {
    on,      ///< so many places are within the tolerance of it that the part is one with it
    leaves,  ///< so it does where it is not beside its borders
    off
  };

  Lying how_lies(const CurvePart& curve, const PatchPart& patch) {
    constexpr std::size_t kMost = 33;
    const std::size_t count = std::min(curve.net.rows * (patch.net.rows + patch.net.columns), kMost);
    pairs_ += kLook;
    PatchSpot foot{patch.piece, patch.middle()};
    bool is_on = true;
    bool is_inside = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = curve.range.start + curve.range.length() * static_cast<double>(i) / static_cast<double>(count - 1);
      const glm::dvec3 point = shapes_.curve.at({curve.piece, t}).point;
      foot = foot_in(shapes_.patch, foot, patch.range, point);
      const bool is_near = glm::length(shapes_.patch.at(foot, point).offset) <= tolerance_;
      const bool is_held = held_at_border(foot, patch.range);
      if (!is_near && !is_held) return Lying::off;
      is_on = is_on && is_near;
      is_inside = is_inside || !is_held;
    }
    return is_on ? Lying::on : is_inside ? Lying::leaves : Lying::off;
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
