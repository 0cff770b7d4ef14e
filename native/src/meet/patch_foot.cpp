#include "patch_foot.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>


namespace splinecore {

namespace {

double held(double t, const Interval& range) { return std::clamp(t, range.start, range.end); }

}  // namespace

std::array<double, 2> held(const std::array<double, 2>& at, const std::array<Interval, 2>& range) {
  return {held(at[0], range[0]), held(at[1], range[1])};
}

PatchSpot foot_in(const PatchPieces& patch, PatchSpot at, const std::array<Interval, 2>& range, const glm::dvec3& point) {
  constexpr int kMost = 12;
  for (int round = 0; round < kMost; ++round) {
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

namespace {

/// From beside a pole, where the patch stands still along a border, a start on the meridian that comes nearest to a point
/// the fastest; none where none does.
std::optional<PatchSpot> start_from_pole(const PatchPieces& patch, const PatchSpot& at, const glm::dvec3& point) {
  constexpr double kBeside = 0x1p-10;
  constexpr int kMeridians = 8;
  constexpr double kMostStep = 0.5;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const bool is_end = at.at[k] > 0.5;
    if (std::min(at.at[k], 1.0 - at.at[k]) > kBeside) continue;
    if (!patch.is_pole(at.piece, {k == 0 ? Axis::u : Axis::v, is_end})) continue;
    const double inwards = is_end ? -1.0 : 1.0;
    std::optional<PatchSpot> best;
    double least = 0.0;
    const auto look = [&](std::size_t in) {
      for (int i = 0; i <= kMeridians; ++i) {
        PatchSpot spot{in, at.at};
        spot.at[k] = is_end ? 1.0 : 0.0;
        spot.at[1 - k] = static_cast<double>(i) / kMeridians;
        const Slopes<2> s = patch.at(spot, point);
        const double speed = glm::length(s.first[k]);
        const double fall = speed > 0.0 ? inwards * glm::dot(s.offset, s.first[k]) / speed : 0.0;
        if (!(fall < least)) continue;
        least = fall;
        spot.at[k] += inwards * std::min(-fall / speed, kMostStep);
        best = spot;
      }
    };
    for (const bool forth : {true, false}) {
      std::optional<std::size_t> piece = at.piece;
      for (std::size_t hops = 0; piece && hops <= patch.size(); ++hops) {
        if (forth || hops > 0) look(*piece);
        piece = patch.beyond(*piece, {k == 0 ? Axis::v : Axis::u, forth});
        if (piece == at.piece) return best;
      }
    }
    return best;
  }
  return {};
}

/// The foot in the piece of a place, and in those beyond its sides.
PatchSpot foot_around(const PatchPieces& patch, PatchSpot at, const glm::dvec3& point) {
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

}  // namespace

PatchSpot patch_foot(const PatchPieces& patch, PatchSpot at, const glm::dvec3& point) {
  at = foot_around(patch, at, point);
  const std::optional<PatchSpot> start = start_from_pole(patch, at, point);
  if (!start) return at;
  const PatchSpot other = foot_around(patch, *start, point);
  const auto distance = [&](const PatchSpot& spot) { return glm::length(patch.at(spot, point).offset); };
  return distance(other) < distance(at) ? other : at;
}

}  // namespace splinecore
