#include "hole.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/length.hpp"
#include "hole_guide.hpp"
#include "least_parts.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// Within a degree or so, at which patches with a corner there would fold.
bool is_straight_on(const glm::dvec3& here, const glm::dvec3& there) {
  constexpr double kStraight = 0.02;
  return length_of(glm::cross(here, there)) <= kStraight * length_of(here) * length_of(there) && glm::dot(here, there) > 0.0;
}

/// Whether a corner that is nearly straight stands up from a neighbor's tangent plane: none could go on from there as a corner.
bool stands_up(const HolePlace& end, const HolePlace& start) {
  constexpr double kNearlyStraight = 0.3;
  constexpr double kUpright = 0.1;
  const glm::dvec3 turn = glm::cross(end.along, start.along);
  if (length_of(turn) > kNearlyStraight * length_of(end.along) * length_of(start.along) || glm::dot(end.along, start.along) <= 0.0) return false;
  const auto is_off = [&](const HolePlace& place) {
    const glm::dvec3 normal = glm::cross(place.out, place.along);
    return length_of(glm::cross(turn, normal)) > kUpright * length_of(turn) * length_of(normal);
  };
  return is_off(end) || is_off(start);
}

/// For each piece whether it is of one side with the next one.
std::vector<bool> joined_to_next(const std::vector<SidePiece>& pieces) {
  std::vector<bool> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SidePiece& next = pieces[(i + 1) % pieces.size()];
    const HolePlace end = pieces[i].place(1.0);
    const HolePlace start = next.place(0.0);
    const bool go_on = pieces[i].continuity() > 0 && next.continuity() > 0;
    found.push_back(go_on && (is_straight_on(end.along, start.along) || stands_up(end, start)));
  }
  constexpr int kLeastCorners = 3;
  if (std::ranges::count(found, false) < kLeastCorners) found.assign(pieces.size(), false);
  return found;
}

void add(std::vector<SidePiece>& side, const SidePiece& piece) {
  std::optional<SidePiece> both = side.empty() ? std::nullopt : SidePiece::of_one_patch(side.back(), piece);
  if (both) {
    side.back() = std::move(*both);
  } else {
    side.push_back(piece);
  }
}

/// A patch has no tangent plane in a corner whose sides go on into each other.
void require_corner(const Hole& hole, std::size_t i) {
  if (!goes_on_at_end(hole, i)) return;
  const HoleSide& side = hole.sides[i];
  const HoleSide& next = hole.sides[hole.after(i)];
  const bool are_alike = side.continuity() > 0 && next.continuity() > 0;
  throw InvalidShape("sides" + index_text(side.numbers().last) + " and sides" + index_text(next.numbers().first) +
                     " join without a corner" +
                     (are_alike ? ", and fewer than three corners are left: make one of them a corner, or let all sides end with G0"
                                : ", one from a neighbor and one not: give both a neighbor, or end both with G0"));
}

/// Each side leaves along the next one at its corners.
void set_ends(Hole& hole) {
  const double h = hole.share;
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    HoleSide& side = hole.sides[i];
    if (side.continuity() == 0) continue;
    const HolePlace end = hole.sides[hole.before(i)].place(1.0);
    const HolePlace start = hole.sides[hole.after(i)].place(0.0);
    require_corner(hole, hole.before(i));
    require_corner(hole, i);
    side.set_end(false, -h * end.along, h * h * end.along_2);
    side.set_end(true, h * start.along, h * h * start.along_2);
  }
}

// Both sides of a corner want the same mixed derivatives there, as nearly as the least change allows: with u along a, s of
// which begins there, and v back along b,
//   S_uv: a.D' = -b.D'    S_uvv: a.D2' = h b.D''    S_uuv: b.D2' = -h a.D''    S_uuvv: a.D2'' = b.D2''
// As far as they may, those of the surface round about agree by themselves.

void agree_on_twist(HoleSide& a, HoleSide& b) {
  const auto parts = least_parts(-(a.jet(false).first[1] + b.jet(true).first[1]), a.directions(false), b.directions(true));
  a.bend_first(false, parts[0], parts[1]);
  b.bend_first(true, parts[2], parts[3]);
}

void agree_on_thirds(HoleSide& a, HoleSide& b, double h) {
  constexpr std::array<glm::dvec3, 2> kNone{glm::dvec3(0.0), glm::dvec3(0.0)};
  if (a.continuity() == 2) {
    const auto parts = least_parts(h * b.jet(true).first[2] - a.jet(false).second[1], a.directions(false), kNone);
    a.bend_second(false, 1, parts[0], parts[1]);
  }
  if (b.continuity() == 2) {
    const auto parts = least_parts(-h * a.jet(false).first[2] - b.jet(true).second[1], kNone, b.directions(true));
    b.bend_second(true, 1, parts[2], parts[3]);
  }
}

void agree_on_fourths(HoleSide& a, HoleSide& b) {
  if (a.continuity() < 2 || b.continuity() < 2) return;
  const std::array<glm::dvec3, 2> of_b = b.directions(true);
  const auto parts = least_parts(b.jet(true).second[2] - a.jet(false).second[2], a.directions(false), {-of_b[0], -of_b[1]});
  a.bend_second(false, 2, parts[0], parts[1]);
  b.bend_second(true, 2, parts[2], parts[3]);
}

/// The derivative along a side, at an end, of what leaves it on a guide; by differences.
glm::dvec3 change_on(const HoleGuide& guide, const Hole& hole, std::size_t i, bool is_end, int order) {
  constexpr double kStep = 0x1p-8;
  const double at = is_end ? 1.0 : 0.0;
  const double way = is_end ? -kStep : kStep;
  const double s[] = {at, at + way, at + 2.0 * way, at + 3.0 * way};
  const std::vector<glm::dvec3> d = guide.across_on_surface(hole, i, s, order);
  return (-11.0 * d[0] + 18.0 * d[1] - 9.0 * d[2] + 2.0 * d[3]) / (6.0 * way);
}

/// Lets what leaves sides change at their ends as on a guide.
void lean_towards(const HoleGuide& guide, Hole& hole, int order) {
  constexpr std::array<glm::dvec3, 2> kNone{glm::dvec3(0.0), glm::dvec3(0.0)};
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    HoleSide& side = hole.sides[i];
    if (side.continuity() < order) continue;
    for (const bool is_end : {false, true}) {
      const AcrossJet jet = side.jet(is_end);
      const glm::dvec3 missing = change_on(guide, hole, i, is_end, order) - (order == 1 ? jet.first[1] : jet.second[1]);
      const auto parts = least_parts(missing, side.directions(is_end), kNone);
      if (order == 1) side.bend_first(is_end, parts[0], parts[1]);
      if (order == 2) side.bend_second(is_end, 1, parts[0], parts[1]);
    }
  }
}

void bulge_towards(const HoleGuide& guide, Hole& hole) {
  for (const int order : {1, 2}) {
    if (order == 2) lean_towards(guide, hole, 2);
    for (std::size_t i = 0; i < hole.sides.size(); ++i) {
      hole.sides[i].bulge_towards([&](std::span<const double> s) { return guide.across_on_surface(hole, i, s, order); }, order, hole.continuity() + 1);
    }
  }
}

}  // namespace

Hole hole_of(const std::vector<SidePiece>& pieces) {
  const std::vector<bool> is_joined = joined_to_next(pieces);
  const std::size_t count = pieces.size();
  Hole hole{{}, 0.5};
  const std::size_t first = static_cast<std::size_t>(std::ranges::find(is_joined, false) - is_joined.begin() + 1) % count;
  std::vector<SidePiece> side;
  std::size_t length = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    add(side, pieces[i]);
    ++length;
    if (is_joined[i]) continue;
    hole.sides.emplace_back(side, SideNumbers{(i + count + 1 - length) % count, i});
    side.clear();
    length = 0;
  }
  const auto has_first = [&](const HoleSide& one) { return one.numbers().first == 0 || one.numbers().first > one.numbers().last; };
  std::ranges::rotate(hole.sides, std::ranges::find_if(hole.sides, has_first));
  if (hole.sides.size() == 4) hole.share = 1.0;
  return hole;
}

bool goes_on_at_end(const Hole& hole, std::size_t i) {
  return is_straight_on(hole.sides[i].place(1.0).along, hole.sides[hole.after(i)].place(0.0).along);
}

void agree_at_corners(Hole& hole, const HoleGuide* guide) {
  set_ends(hole);
  for (std::size_t i = 0; i < hole.sides.size(); ++i) {
    HoleSide& side = hole.sides[i];
    std::vector<double> lengths;
    if (guide) {
      for (const glm::dvec3& d : guide->across_on_surface(hole, i, side.joints(), 1)) lengths.push_back(length_of(d));
    }
    side.agree_at_joints(lengths);
  }
  const auto at_corners = [&](const auto& agree) {
    for (std::size_t i = 0; i < hole.sides.size(); ++i) {
      HoleSide& side = hole.sides[i];
      HoleSide& before = hole.sides[hole.before(i)];
      if (side.continuity() > 0 && before.continuity() > 0) agree(side, before);
    }
  };
  if (guide) lean_towards(*guide, hole, 1);
  at_corners(agree_on_twist);
  for (HoleSide& side : hole.sides) {
    if (side.continuity() > 0) side.bend_onward();
  }
  if (guide) bulge_towards(*guide, hole);
  at_corners([&](HoleSide& a, HoleSide& b) { agree_on_thirds(a, b, hole.share); });
  at_corners(agree_on_fourths);
}

}  // namespace splinecore
