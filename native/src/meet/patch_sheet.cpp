#include "patch_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>


namespace splinecore {

namespace {

/// Both parameters with the numbers of their spans, which rise over the whole patch.
using OverSpans = std::array<double, 2>;

std::array<std::size_t, 2> spans_of(const PatchPieces& patch) {
  return {patch.knots(Axis::u).spans().size(), patch.knots(Axis::v).spans().size()};
}

OverSpans place_of(const PatchPieces& patch, const PatchSpot& spot) {
  const std::size_t columns = spans_of(patch)[1];
  return {static_cast<double>(spot.piece / columns) + spot.at[0], static_cast<double>(spot.piece % columns) + spot.at[1]};
}

PatchSpot spot_of(const PatchPieces& patch, OverSpans place) {
  const std::array<std::size_t, 2> counts = spans_of(patch);
  std::array<std::size_t, 2> spans{};
  PatchSpot spot{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto count = static_cast<double>(counts[k]);
    if (place[k] < 0.0 || place[k] > count) place[k] -= std::floor(place[k] / count) * count;
    spans[k] = std::min(static_cast<std::size_t>(place[k]), counts[k] - 1);
    spot.at[k] = std::clamp(place[k] - static_cast<double>(spans[k]), 0.0, 1.0);
  }
  spot.piece = spans[0] * counts[1] + spans[1];
  return spot;
}

/// By how much places may be counted further: whole turns where the patch goes on over its end.
std::vector<double> turns_along(const PatchPieces& patch, Axis axis, const PatchSpot& at) {
  const std::array<std::size_t, 2> counts = spans_of(patch);
  const bool is_u = axis == Axis::u;
  const std::size_t first = is_u ? at.piece % counts[1] : at.piece / counts[1] * counts[1];
  if (!patch.beyond(first, {axis, false})) return {0.0};
  const auto turn = static_cast<double>(counts[is_u ? 0 : 1]);
  return {0.0, turn, -turn};
}

bool stays_near(const PatchPieces& patch, const OverSpans& from, const OverSpans& to, const glm::dvec3& point, double distance) {
  constexpr int kPlaces = 16;
  for (int i = 0; i <= kPlaces; ++i) {
    const double share = static_cast<double>(i) / kPlaces;
    const OverSpans place{from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
    if (!(glm::length(patch.at(spot_of(patch, place), point).offset) <= distance)) return false;
  }
  return true;
}

}  // namespace

bool are_on_one_sheet(const PatchPieces& patch, const PatchSpot& one, const PatchSpot& other, const glm::dvec3& point,
                      double distance) {
  const OverSpans from = place_of(patch, one);
  const OverSpans to = place_of(patch, other);
  for (const double u : turns_along(patch, Axis::u, one)) {
    for (const double v : turns_along(patch, Axis::v, one)) {
      if (stays_near(patch, from, {to[0] + u, to[1] + v}, point, distance)) return true;
    }
  }
  return false;
}

}  // namespace splinecore
