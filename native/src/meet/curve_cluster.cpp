#include "curve_cluster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "zero_between.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kCount = 33;

/// How curves lie at a pair of places.
struct Crossing {
  glm::dvec3 gap;
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
  return {b.offset, glm::cross(unit(a.first[0]), unit(b.first[0])),
          curvature_vector(b.first[0], b.second[0]) - curvature_vector(a.first[0], a.second[0])};
}

std::array<double, kCount> places_of(const CurveCluster& cluster) {
  std::array<double, kCount> places;
  for (std::size_t i = 0; i < kCount; ++i) {
    places[i] = cluster.a().start + cluster.a().length() * static_cast<double>(i) / (kCount - 1);
  }
  return places;
}

/// The place that curves touch or cross at of those of a cluster.
struct Meeting {
  double place;
  bool touches;
};

Meeting meeting_of(const CurveCluster& cluster, const TwoCurves& curves, const std::array<double, kCount>& places,
                   std::size_t best) {
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
  double place = places[best];
  if (turns_in(gap, whole)) {
    place = zero_between(whole, gap);
    // Where they cross and have a tangent in common the difference of their curvatures is zero.
    if (is_parallel(place) && turns_in(bend, whole)) place = zero_between(whole, bend);
  } else if (turns_in(normal, around)) {
    place = zero_between(around, normal);
  }
  return {place, is_parallel(place)};
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

void CurveCluster::add_ends(std::vector<double>& places) const {
  constexpr std::size_t kMost = 64;
  const std::size_t step = stretches_.size() / kMost + 1;
  for (std::size_t i = 0; i < stretches_.size(); i += step) {
    places.push_back(stretches_[i].a.start);
    places.push_back(stretches_[i].a.end);
  }
}

SpotPair CurveCluster::at(const TwoCurves& curves, double place) const {
  // What goes round a closed curve begins anywhere.
  const bool is_round = curves.a.is_closed() && a_.length() >= curves.a.turn();
  const double turn = is_round ? curves.a.turn() : 0.0;
  const LaidStretch* nearest = nullptr;
  double t = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double further : {0.0, turn, -turn}) {
    for (const LaidStretch& laid : stretches_) {
      const double distance = std::max({laid.a.start - place - further, place + further - laid.a.end, 0.0});
      if (!(distance < least)) continue;
      least = distance;
      nearest = &laid;
      t = place + further - laid.turns.a - curves.a.place({laid.stretch.piece_a, 0.0});
    }
    if (!is_round || least == 0.0) break;
  }
  const CurveStretch& on = nearest->stretch;
  const CurveSpot spot{on.piece_a, std::clamp(t, on.a.start, on.a.end)};
  return {spot, {on.piece_b, foot_of(curves.b, on.piece_b, on.b, curves.a.at(spot).point)}};
}

/// Most of the length of the first curve, whatever its pace: looked at between the ends of stretches, too. What is much of
/// one of the curves is one though it is not so near, as where weights leave but few digits.
bool is_overlap(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  // Curves that only touch are nearly a tolerance apart along most of a cluster.
  constexpr double kOne = 0x1p-6;
  constexpr double kMuch = 0.25;
  if (!cluster.has_stretches()) return false;
  const auto uniform = places_of(cluster);
  std::vector<double> places(uniform.begin(), uniform.end());
  cluster.add_ends(places);
  std::ranges::sort(places);
  double near = 0.0;
  double length = 0.0;
  glm::dvec3 before(0.0);
  bool was_near = false;
  bool is_within = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SpotPair at = cluster.at(curves, places[i]);
    const glm::dvec3 point = curves.a.at(at.a).point;
    const double distance = curves.distance(at);
    const bool is_near = distance <= kOne * tolerance;
    is_within = is_within && distance <= tolerance;
    const double step = i > 0 ? glm::distance(point, before) : 0.0;
    length += step;
    if (is_near && was_near) near += step;
    was_near = is_near;
    before = point;
  }
  const bool is_much = is_within && length >= kMuch * std::min(curves.a.length(), curves.b.length());
  return length > 8.0 * tolerance && (4.0 * near >= 3.0 * length || is_much);
}

ClusterShape shape_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  if (is_overlap(cluster, curves, tolerance)) return {true, {}, true};
  if (cluster.has_stretches()) {
    const auto places = places_of(cluster);
    const auto distance_at = [&](double place) { return curves.distance(cluster.at(curves, place)); };
    const auto best = static_cast<std::size_t>(std::ranges::min_element(places, {}, distance_at) - places.begin());
    const Meeting meeting = meeting_of(cluster, curves, places, best);
    for (const SpotPair& at : {cluster.at(curves, meeting.place), cluster.at(curves, places[best])}) {
      if (curves.distance(at) <= tolerance) return {false, at, meeting.touches};
    }
    const SpotPair lowest = settled(curves, cluster.at(curves, places[best]));
    const SpotPair from = cluster.at(curves, places[best]);
    if (curves.distance(lowest) <= tolerance && curves.a.are_one(from.a, lowest.a, 4.0 * tolerance)) {
      return {false, lowest, meeting.touches};
    }
  }
  if (cluster.crossings().empty()) return {false, {}, false};
  const auto distance = [&](const SpotPair& at) { return curves.distance(at); };
  return {false, *std::ranges::min_element(cluster.crossings(), {}, distance), false};
}

}  // namespace splinecore
