#include "crossing_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using BoxPair = std::pair<OffsetBox, OffsetBox>;

bool can_be_halved(const OffsetBox& box) {
  constexpr double kLast = 0x1p-48;
  const Interval& part = box.part();
  return part.length() > kLast * std::max(1.0, std::abs(part.middle()));
}

bool holds(const Interval& part, double u) {
  const double room = 0x1p-20 * part.length();
  return u >= part.start - room && u <= part.end + room;
}

bool holds(const BoxPair& pair, const TouchedBoth& places) {
  return holds(pair.first.part(), places.a) && holds(pair.second.part(), places.b);
}

/// Whether Newton's method may go from the middles.
bool is_nearly_straight(const BoxPair& pair) {
  constexpr double kStraight = 0.5;
  return pair.first.half_angle() < kStraight && pair.second.half_angle() < kStraight;
}

/// Whether tangents are seen to cross everywhere, so that there is one place at most that touches both.
bool cross_once(const BoxPair& pair) {
  const glm::dvec2& a = pair.first.way();
  const glm::dvec2& b = pair.second.way();
  const double between = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
  const double room = pair.first.half_angle() + pair.second.half_angle();
  return between > room && between < std::numbers::pi - room;
}

/// Whether what touches both there is one arc, as far as arcs are told apart.
bool are_one_place(const BoxPair& pair, double radius) {
  constexpr double kSamePlace = 0x1p-22;
  return std::max(pair.first.size(), pair.second.size()) <= kSamePlace * radius;
}

}  // namespace

CrossingSearch::CrossingSearch(const NurbsCurve& a, const NurbsCurve& b, const glm::dvec3& normal, const std::array<double, 2>& sides)
    : view_(normal),
      both_(a, b, normal, sides),
      radius_(std::abs(sides[0])),
      reach_(std::max(0x1p-5 * std::abs(sides[0]), 0x1p-9)),
      beside_a_(offset_boxes(a, view_, sides[0])),
      beside_b_(offset_boxes(b, view_, sides[1])) {}

std::vector<Fillet> CrossingSearch::near(const glm::dvec3& center) const {
  constexpr int kMost = 1 << 14;
  const glm::dvec2 place = view_.seen(center);
  const auto is_off = [&](const OffsetBox& box) { return is_beyond(box, place, reach_); };
  std::vector<OffsetBox> near_b = beside_b_;
  std::erase_if(near_b, is_off);
  std::vector<BoxPair> open;
  for (const OffsetBox& box : beside_a_) {
    if (is_off(box)) continue;
    for (const OffsetBox& other : near_b) open.emplace_back(box, other);
  }
  std::vector<Fillet> found;
  for (int count = 0; !open.empty(); ++count) {
    breathe(256);
    if (count > kMost) throw CrossingUndecided(center);
    const BoxPair pair = std::move(open.back());
    open.pop_back();
    if (is_off(pair.first) || is_off(pair.second) || are_apart(pair.first, pair.second)) continue;
    if (is_nearly_straight(pair)) {
      const auto made = both_.near(pair.first.part().middle(), pair.second.part().middle());
      if (made && holds(pair, *made)) {
        if (made->fillet) found.push_back(*made->fillet);
        if (cross_once(pair) || are_one_place(pair, radius_)) continue;
      }
    }
    const bool can_a = can_be_halved(pair.first);
    const bool can_b = can_be_halved(pair.second);
    // To the last digits, what has no tangent is touched by nothing.
    if ((!can_a && !pair.first.is_bounded()) || (!can_b && !pair.second.is_bounded())) continue;
    if (!can_a && !can_b) {
      const auto made = both_.at(pair.first.part().middle(), pair.second.part().middle());
      if (made && made->fillet) found.push_back(*made->fillet);
      continue;
    }
    if (can_a && (!can_b || pair.first.size() >= pair.second.size())) {
      auto [one, other] = pair.first.halves();
      open.emplace_back(std::move(one), pair.second);
      open.emplace_back(std::move(other), pair.second);
    } else {
      auto [one, other] = pair.second.halves();
      open.emplace_back(pair.first, std::move(one));
      open.emplace_back(pair.first, std::move(other));
    }
  }
  return found;
}

}  // namespace splinecore
