#include "matched_axes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "patch_foot.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using AxisMatches = std::array<AxisMatch, 2>;

Interval domain_of(const PatchPieces& patch, std::size_t k) { return patch.knots(k == 0 ? Axis::u : Axis::v).domain(); }

void add_whole(const TwoPatches& patches, std::vector<AxisMatches>& found) {
  for (int way = 0; way < 8; ++way) {
    const bool is_exchanged = (way & 1) != 0;
    const auto along = [&](std::size_t k) {
      const std::size_t own = is_exchanged ? 1 - k : k;
      const Interval of_b = domain_of(patches.b, own);
      const bool is_reversed = (way & (k == 0 ? 2 : 4)) != 0;
      return AxisMatch{own == 0 ? Axis::u : Axis::v, domain_of(patches.a, k), is_reversed ? of_b.end : of_b.start,
                       is_reversed ? of_b.start : of_b.end};
    };
    found.push_back({along(0), along(1)});
  }
}

/// The place of a patch where it is nearest to a point, as far as the nearest of looks all over it lead there.
PatchSpot nearest_spot(const PatchPieces& patch, const glm::dvec3& point) {
  constexpr std::array<double, 3> kLooks{0.125, 0.5, 0.875};
  constexpr std::size_t kMost = 6;
  const auto distance = [&](const PatchSpot& spot) { return glm::length(patch.at(spot, point).offset); };
  std::vector<std::pair<double, PatchSpot>> starts;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    breathe(512);
    std::pair<double, PatchSpot> best{std::numeric_limits<double>::infinity(), {i, {0.5, 0.5}}};
    for (const double u : kLooks) {
      for (const double v : kLooks) {
        const PatchSpot spot{i, {u, v}};
        const double far = distance(spot);
        if (far < best.first) best = {far, spot};
      }
    }
    starts.push_back(best);
  }
  const std::size_t count = std::min(kMost, starts.size());
  std::ranges::partial_sort(starts, starts.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [](const auto& start) { return start.first; });
  std::pair<double, PatchSpot> best{std::numeric_limits<double>::infinity(), starts.front().second};
  for (std::size_t i = 0; i < count; ++i) {
    const PatchSpot foot = patch_foot(patch, starts[i].second, point);
    const double far = distance(foot);
    if (far < best.first) best = {far, foot};
  }
  return best.second;
}

double snapped(double t, const Interval& domain) {
  constexpr double kNear = 0x1p-24;
  if (std::abs(t - domain.start) <= kNear * domain.length()) return domain.start;
  return std::abs(t - domain.end) <= kNear * domain.length() ? domain.end : t;
}

/// How parameters of a part go over the whole, if its places are on that evenly.
std::optional<AxisMatches> match_in(const PatchPieces& part, const PatchPieces& whole, double tolerance) {
  constexpr std::array<std::array<double, 2>, 4> kLooks{{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}};
  constexpr double kEven = 0x1p-10;
  const std::array<Interval, 2> own{domain_of(part, 0), domain_of(part, 1)};
  std::array<std::array<double, 2>, 4> at{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array<double, 2> place{std::lerp(own[0].start, own[0].end, kLooks[i][0]),
                                      std::lerp(own[1].start, own[1].end, kLooks[i][1])};
    const glm::dvec3 point = part.at(part.spot(place)).point;
    const PatchSpot foot = nearest_spot(whole, point);
    if (!(glm::length(whole.at(foot, point).offset) <= tolerance)) return {};
    at[i] = whole.parameters(foot);
  }
  const std::array<double, 2> size{domain_of(whole, 0).length(), domain_of(whole, 1).length()};
  const auto way = [&](std::size_t from, std::size_t to, std::size_t k) { return at[to][k] - at[from][k]; };
  const bool is_exchanged = std::abs(way(0, 1, 1)) / size[1] > std::abs(way(0, 1, 0)) / size[0];
  AxisMatches found{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t there = is_exchanged ? 1 - k : k;
    const double half = 0.5 * (way(0, k + 1, there) + way(2 - k, 3, there));
    const double off = std::abs(way(0, k + 1, there) - half) / size[there] +
                       (std::abs(way(0, k + 1, 1 - there)) + std::abs(way(2 - k, 3, 1 - there))) / size[1 - there];
    if (!(off <= kEven * std::abs(half) / size[there])) return {};
    const double first = 0.5 * (at[0][there] + at[2 - k][there]) - 0.5 * half;
    const Interval range = domain_of(whole, there);
    const double start = snapped(first, range);
    const double end = snapped(first + 2.0 * half, range);
    if (std::min(start, end) < range.start || std::max(start, end) > range.end) return {};
    found[k] = {there == 0 ? Axis::u : Axis::v, own[k], start, end};
  }
  return found;
}

/// The same matches by the parameters of the other patch.
AxisMatches inverse(const AxisMatches& matches) {
  AxisMatches found{};
  for (std::size_t k = 0; k < 2; ++k) {
    const AxisMatch& match = matches[k];
    const bool is_reversed = match.end < match.start;
    found[match.axis == Axis::u ? 0 : 1] = {k == 0 ? Axis::u : Axis::v,
                                            {std::min(match.start, match.end), std::max(match.start, match.end)},
                                            is_reversed ? match.from.end : match.from.start,
                                            is_reversed ? match.from.start : match.from.end};
  }
  return found;
}

}  // namespace

std::vector<AxisMatches> axis_matches(const TwoPatches& patches, double tolerance) {
  std::vector<AxisMatches> found;
  add_whole(patches, found);
  if (const auto match = match_in(patches.b, patches.a, tolerance)) found.push_back(inverse(*match));
  if (const auto match = match_in(patches.a, patches.b, tolerance)) found.push_back(*match);
  return found;
}

}  // namespace splinecore
