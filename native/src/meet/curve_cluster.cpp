#include "curve_cluster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/sort_by.hpp"
#include "curve_contact.hpp"
#include "near_space.hpp"
#include "zero_between.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kCount = 33;

/// How curves lie at a pair of places.
struct Crossing {
  glm::dvec3 gap;     ///< across the first one
  glm::dvec3 normal;  ///< of both tangents, as long as the sine of their angle
  glm::dvec3 bend;    ///< the difference of their curvature vectors
};

/// The part of the second derivative across the first one, by its square.
glm::dvec3 curvature_vector(const glm::dvec3& first, const glm::dvec3& second) {
  const double square = glm::dot(first, first);
  return square > 0.0 ? (second - glm::dot(second, first) / square * first) / square : glm::dvec3(0.0);
}

Crossing crossing_at(const TwoCurves& curves, const SpotPair& at) {
  const Slopes<1> a = curves.a.at(at.a);
  const Slopes<1> b = curves.b.at(at.b, a.point);
  const auto unit = [](const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : v;
  };
  const glm::dvec3 along = unit(a.first[0]);
  return {b.offset - glm::dot(b.offset, along) * along, glm::cross(along, unit(b.first[0])),
          curvature_vector(b.first[0], b.second[0]) - curvature_vector(a.first[0], a.second[0])};
}

std::array<double, kCount> places_of(const Interval& along) {
  std::array<double, kCount> places;
  for (std::size_t i = 0; i < kCount; ++i) {
    places[i] = std::lerp(along.start, along.end, static_cast<double>(i) / (kCount - 1));
  }
  return places;
}

/// Of the first curve's places those from the first to the last one within the tolerance; all where none is seen to be.
Interval within(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  Interval along = cluster.a();
  if (cluster.is_round(curves)) return along;
  const auto places = places_of(along);
  const auto is_near = [&](double place) { return curves.distance(cluster.at(curves, place)) <= tolerance; };
  const auto first = std::ranges::find_if(places, is_near);
  if (first == places.end()) return along;
  const auto last = std::ranges::find_if(places.rbegin(), places.rend(), is_near);
  const auto edge = [&](double near, double far) {
    constexpr int kHalvings = 52;
    for (int i = 0; i < kHalvings; ++i) (is_near(0.5 * (near + far)) ? near : far) = 0.5 * (near + far);
    return near;
  };
  if (first != places.begin()) along.start = edge(*first, *std::prev(first));
  if (last != places.rbegin()) along.end = edge(*last, *std::prev(last));
  return along;
}

/// The place that curves touch or cross at of those of a cluster.
struct Meeting {
  double place;
  bool touches;
};

Meeting meeting_of(const CurveCluster& cluster, const TwoCurves& curves, const std::array<double, kCount>& places,
                   std::size_t best, double tolerance) {
  const auto gap = [&](double place) { return crossing_at(curves, cluster.at(curves, place)).gap; };
  const auto normal = [&](double place) { return crossing_at(curves, cluster.at(curves, place)).normal; };
  const auto bend = [&](double place) { return crossing_at(curves, cluster.at(curves, place)).bend; };
  const auto turns_in = [](const auto& vector, const Interval& in) {
    return glm::dot(vector(in.start), vector(in.end)) < 0.0;
  };
  const Interval whole{places.front(), places.back()};
  const Interval around{places[best == 0 ? 0 : best - 1], places[std::min(best + 1, kCount - 1)]};
  const double sine_at_ends = std::max(glm::length(normal(whole.start)), glm::length(normal(whole.end)));
  const auto is_parallel = [&](double place) {
    constexpr double kParallel = 1e-6;
    return glm::length(normal(place)) <= std::max(0.5 * sine_at_ends, kParallel);
  };
  // Where one of the curves ends in a contact that is flat up to rounding, rounding alone would turn to and fro.
  const auto is_still = [&](double place) {
    const double rounding = 0x1p-48 + 4.0 * curves.rounding;
    const Crossing there = crossing_at(curves, cluster.at(curves, place));
    return glm::length(there.gap) <= rounding && glm::length(there.normal) <= 16.0 * rounding;
  };
  const std::array<bool, 2> are_still{is_still(whole.start), is_still(whole.end)};
  if (are_still[0] != are_still[1]) return {are_still[0] ? whole.start : whole.end, true};
  double place = places[best];
  if (turns_in(gap, whole)) {
    place = zero_between(whole, gap);
    // Where they cross and have a tangent in common the difference of their curvatures is zero.
    if (is_parallel(place) && turns_in(bend, whole)) place = zero_between(whole, bend);
  } else if (turns_in(normal, around)) {
    place = zero_between(around, normal);
  }
  if (!is_parallel(place)) return {place, false};
  if (const auto contact = contact_in(cluster, curves, within(cluster, curves, tolerance))) {
    return {std::clamp(*contact, whole.start, whole.end), true};
  }
  return {place, true};
}

}  // namespace

namespace {

bool is_of_same_pieces(const LaidStretch& one, const LaidStretch& other) {
  return one.turns.a == other.turns.a && one.turns.b == other.turns.b &&
         one.stretch.piece_a == other.stretch.piece_a && one.stretch.piece_b == other.stretch.piece_b;
}

}  // namespace

void CurveCluster::add(const LaidStretch& laid) {
  const auto joined = [](const Interval& a, const Interval& b) {
    return Interval{std::min(a.start, b.start), std::max(a.end, b.end)};
  };
  a_ = stretches_.empty() ? laid.a : joined(a_, laid.a);
  b_ = stretches_.empty() ? laid.b : joined(b_, laid.b);
  stretches_.push_back(laid);
}

void CurveCluster::add_ends(std::vector<double>& places, const Interval& in) const {
  constexpr std::size_t kMost = 64;
  const std::size_t step = stretches_.size() / kMost + 1;
  for (std::size_t i = 0; i < stretches_.size(); i += step) {
    places.push_back(std::clamp(stretches_[i].a.start, in.start, in.end));
    places.push_back(std::clamp(stretches_[i].a.end, in.start, in.end));
  }
}

Interval CurveCluster::longest_in_pieces(const Interval& in) const {
  std::vector<LaidStretch> sorted = stretches_;
  sort_by(sorted, [](const LaidStretch& laid) { return laid.a.start; });
  std::vector<Interval> smooth;
  std::vector<const LaidStretch*> of;
  for (const LaidStretch& laid : sorted) {
    const auto is_same = [&](const LaidStretch* other) { return is_of_same_pieces(*other, laid); };
    const auto same = std::ranges::find_if(of, is_same);
    if (same == of.end()) {
      of.push_back(&laid);
      smooth.push_back(laid.a);
    } else {
      Interval& own = smooth[static_cast<std::size_t>(same - of.begin())];
      own.end = std::max(own.end, laid.a.end);
    }
  }
  Interval longest{in.start, in.start};
  for (const Interval& own : smooth) {
    const Interval held{std::max(own.start, in.start), std::min(own.end, in.end)};
    if (held.length() > longest.length()) longest = held;
  }
  return longest;
}

bool CurveCluster::holds(const TwoCurves& curves, double place) const {
  const double turn = is_round(curves) ? curves.a.turn() : 0.0;
  return std::ranges::any_of(stretches_, [&](const LaidStretch& laid) {
    return std::ranges::any_of(std::array{0.0, turn, -turn}, [&](double further) {
      return laid.a.start <= place + further && place + further <= laid.a.end;
    });
  });
}

SpotPair CurveCluster::at(const TwoCurves& curves, double place) const {
  // What goes round a closed curve begins anywhere.
  const double turn = is_round(curves) ? curves.a.turn() : 0.0;
  const auto beyond = [&](const LaidStretch& laid, double at) {
    return std::max({laid.a.start - at, at - laid.a.end, 0.0});
  };
  double least = std::numeric_limits<double>::infinity();
  for (const double further : {0.0, turn, -turn}) {
    for (const LaidStretch& laid : stretches_) least = std::min(least, beyond(laid, place + further));
  }
  std::optional<SpotPair> nearest;
  double distance = 0.0;
  const auto look = [&](const LaidStretch& laid, double at) {
    if (nearest && distance == 0.0) return;
    const CurveStretch& on = laid.stretch;
    const double t = at - laid.turns.a - curves.a.place({on.piece_a, 0.0});
    const CurveSpot spot{on.piece_a, std::clamp(t, on.a.start, on.a.end)};
    const SpotPair pair{spot, {on.piece_b, foot_of(curves.b, on.piece_b, on.b, curves.a.at(spot).point)}};
    const double own = curves.distance(pair);
    if (nearest && !(own < distance)) return;
    nearest = pair;
    distance = own;
  };
  for (const double further : {0.0, turn, -turn}) {
    for (const LaidStretch& laid : stretches_) {
      if (beyond(laid, place + further) <= least) look(laid, place + further);
    }
    if (turn == 0.0) break;
  }
  return *nearest;
}

SpotPair CurveCluster::nearest(const TwoCurves& curves) const {
  std::optional<SpotPair> best;
  for (const LaidStretch& laid : stretches_) {
    const CurveStretch& on = laid.stretch;
    for (const double t : {on.a.start, on.a.middle(), on.a.end}) {
      const glm::dvec3 point = curves.a.at({on.piece_a, t}).point;
      SpotPair at{{on.piece_a, t}, {on.piece_b, foot_of(curves.b, on.piece_b, on.b, point)}};
      at = nearest_pair(curves, at, on.a, on.b).value_or(at);
      if (!best || curves.distance(at) < curves.distance(*best)) best = at;
    }
  }
  return *best;
}

namespace {

/// How far apart curves are at places of a cluster, and how long each step to the next one is.
struct Profile {
  std::vector<double> distances;
  std::vector<double> steps;
  double length = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
};

/// Whatever the pace of the first curve: looked at between the ends of stretches, too.
Profile profile_of(const CurveCluster& cluster, const TwoCurves& curves, const Interval& along) {
  const auto uniform = places_of(along);
  std::vector<double> places(uniform.begin(), uniform.end());
  cluster.add_ends(places, along);
  std::ranges::sort(places);
  Profile profile;
  glm::dvec3 before(0.0);
  for (const double place : places) {
    const SpotPair at = cluster.at(curves, place);
    const glm::dvec3 point = curves.a.at(at.a).point;
    const double distance = curves.distance(at);
    if (!profile.distances.empty()) profile.steps.push_back(glm::distance(point, before));
    profile.distances.push_back(distance);
    profile.least = std::min(profile.least, distance);
    profile.most = std::max(profile.most, distance);
    before = point;
  }
  for (const double step : profile.steps) profile.length += step;
  return profile;
}

/// Along how much of it curves are evenly near: at most so much farther apart than where they are nearest.
double length_within(const Profile& profile, double distance) {
  double length = 0.0;
  for (std::size_t i = 0; i < profile.steps.size(); ++i) {
    if (std::max(profile.distances[i], profile.distances[i + 1]) <= distance) length += profile.steps[i];
  }
  return length;
}

/// Whether one of the curves ends where they are side by side no more, at both ends.
bool is_between_ends(const CurveCluster& cluster, const TwoCurves& curves, const Interval& along, double tolerance) {
  const auto does_end = [&](double place) {
    const auto [on_a, on_b] = curves.places(cluster.at(curves, place));
    return curves.a.ends_near(on_a, tolerance) || curves.b.ends_near(on_b, tolerance);
  };
  return cluster.is_round(curves) || (does_end(along.start) && does_end(along.end));
}

}  // namespace

std::optional<Interval> overlap_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  if (!cluster.has_stretches()) return {};
  const Interval along = within(cluster, curves, tolerance);
  const Profile profile = profile_of(cluster, curves, along);
  if (!(profile.least <= tolerance && profile.length > 8.0 * tolerance)) return {};
  // Curves that only touch are nearly a tolerance apart along most of a cluster.
  const double even = profile.least + distance_of_one(tolerance - profile.least, curves.rounding);
  if (4.0 * length_within(profile, even) >= 3.0 * profile.length) return along;
  const bool is_within = profile.most <= kWide * tolerance;
  return is_within && is_between_ends(cluster, curves, along, tolerance) ? std::optional(along) : std::nullopt;
}

ClusterShape shape_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  if (const auto overlap = overlap_of(cluster, curves, tolerance)) return {overlap};
  if (cluster.has_stretches()) {
    const auto places = places_of(cluster.a());
    const auto distance_at = [&](double place) { return curves.distance(cluster.at(curves, place)); };
    const auto best = static_cast<std::size_t>(std::ranges::min_element(places, {}, distance_at) - places.begin());
    const Meeting meeting = meeting_of(cluster, curves, places, best, tolerance);
    for (const SpotPair& at : {cluster.at(curves, meeting.place), cluster.at(curves, places[best])}) {
      if (curves.distance(at) <= tolerance) return {{}, at, meeting.touches};
    }
    const SpotPair lowest = settled(curves, cluster.at(curves, places[best]));
    const SpotPair from = cluster.at(curves, places[best]);
    if (curves.distance(lowest) <= tolerance && curves.a.are_one(from.a, lowest.a, 4.0 * tolerance)) {
      return {{}, lowest, meeting.touches};
    }
    const SpotPair nearest = cluster.nearest(curves);
    if (curves.distance(nearest) <= tolerance) return {{}, nearest, meeting.touches};
  }
  if (cluster.crossings().empty()) return {};
  const auto distance = [&](const SpotPair& at) { return curves.distance(at); };
  const SpotPair nearest = *std::ranges::min_element(cluster.crossings(), {}, distance);
  return distance(nearest) <= tolerance ? ClusterShape{{}, nearest} : ClusterShape{};
}

}  // namespace splinecore
