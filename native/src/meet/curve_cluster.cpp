#include "base/sort_by.hpp"
#include "curve_cluster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "zero_between.hpp"

namespace splinecore {

namespace {

double place_a(const CurveStretch& s, double t) { return CurvePieces::place({s.piece_a, t}); }
double place_b(const CurveStretch& s, double t) { return CurvePieces::place({s.piece_b, t}); }
Interval along_a(const CurveStretch& s) { return {place_a(s, s.a.start), place_a(s, s.a.end)}; }
Interval along_b(const CurveStretch& s) { return {place_b(s, s.b.start), place_b(s, s.b.end)}; }

Interval joined(const Interval& a, const Interval& b) { return {std::min(a.start, b.start), std::max(a.end, b.end)}; }

Interval moved(const Interval& in, double by) { return {in.start + by, in.end + by}; }

/// How many places further a stretch lies beside another one; on a closed curve it may be a turn further.
std::optional<double> turn_beside(const CurvePieces& curve, const Interval& in, const Interval& stretch,
                                  double tolerance) {
  if (curve.are_beside(in, stretch, tolerance)) return 0.0;
  if (!curve.is_closed()) return {};
  const auto turn = static_cast<double>(curve.size());
  for (const double turns : {1.0, -1.0, 2.0}) {
    if (curve.are_beside(in, moved(stretch, turns * turn), tolerance)) return turns * turn;
  }
  return {};
}

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

/// A cluster with all of others that it reaches, which are taken out of them.
CurveCluster merged(const TwoCurves& curves, CurveCluster cluster, std::vector<CurveCluster>& others, double tolerance) {
  std::vector<CurveCluster> rest;
  for (CurveCluster& other : others) {
    if (const auto turns = other.reaches(curves, cluster.a(), cluster.b(), tolerance)) {
      other.add(cluster, *turns);
      cluster = std::move(other);
    } else {
      rest.push_back(std::move(other));
    }
  }
  others = std::move(rest);
  return cluster;
}

/// Of a closed first curve those that go on from its end to its start put together.
std::vector<CurveCluster> merged_at_seam(const TwoCurves& curves, std::vector<CurveCluster> clusters, double tolerance) {
  const auto end = static_cast<double>(curves.a.size());
  const auto is_at_start = [&](const CurveCluster& c) { return curves.a.are_beside(c.a(), {0.0, 0.0}, tolerance); };
  const auto inner = std::partition(clusters.begin(), clusters.end(), is_at_start);
  std::vector<CurveCluster> found(std::make_move_iterator(inner), std::make_move_iterator(clusters.end()));
  clusters.erase(inner, clusters.end());
  sort_by(found, [](const CurveCluster& c) { return -c.a().end; });
  for (CurveCluster& cluster : clusters) {
    const auto goes_on = [&](const CurveCluster& c) {
      return curves.a.are_beside(c.a(), {end, end}, tolerance) &&
             c.reaches(curves, cluster.a(), cluster.b(), tolerance).has_value();
    };
    const auto before = std::ranges::find_if(found, goes_on);
    if (before == found.end()) {
      found.push_back(std::move(cluster));
    } else {
      before->add(cluster, *before->reaches(curves, cluster.a(), cluster.b(), tolerance));
    }
  }
  return found;
}

}  // namespace

CurveCluster::CurveCluster(const CurveStretch& first)
    : stretches_{{first, {}}}, a_(along_a(first)), b_(along_b(first)), is_trivial_(first.is_trivial) {}

std::optional<Turns> CurveCluster::reaches(const TwoCurves& curves, const Interval& a, const Interval& b,
                                           double tolerance) const {
  const std::optional<double> of_a = turn_beside(curves.a, a_, a, tolerance);
  if (!of_a) return {};
  const std::optional<double> of_b = turn_beside(curves.b, b_, b, tolerance);
  if (!of_b) return {};
  return Turns{*of_a, *of_b};
}

void CurveCluster::add(const CurveCluster& other, const Turns& turns) {
  for (const Laid& laid : other.stretches_) {
    stretches_.push_back({laid.stretch, {laid.turns.a + turns.a, laid.turns.b + turns.b}});
  }
  a_ = joined(a_, moved(other.a_, turns.a));
  b_ = joined(b_, moved(other.b_, turns.b));
  is_trivial_ = is_trivial_ || other.is_trivial_;
}

SpotPair CurveCluster::at(const TwoCurves& curves, double place) const {
  const auto distance_to = [&](const Laid& laid) {
    const Interval in = moved(along_a(laid.stretch), laid.turns.a);
    return std::max({in.start - place, place - in.end, 0.0});
  };
  const Laid& nearest = *std::ranges::min_element(stretches_, {}, distance_to);
  const CurveStretch& on = nearest.stretch;
  const double t = place - nearest.turns.a - static_cast<double>(on.piece_a);
  const CurveSpot spot{on.piece_a, std::clamp(t, on.a.start, on.a.end)};
  return {spot, {on.piece_b, foot_of(curves.b, on.piece_b, on.b, curves.a.at(spot).point)}};
}

std::vector<CurveCluster> clusters_of(const TwoCurves& curves, std::vector<CurveStretch> stretches, double tolerance) {
  sort_by(stretches, [](const CurveStretch& s) { return along_a(s).start; });
  std::vector<CurveCluster> done;
  std::vector<CurveCluster> open;
  for (const CurveStretch& stretch : stretches) {
    const auto behind = std::partition(open.begin(), open.end(), [&](const CurveCluster& cluster) {
      return curves.a.are_beside(cluster.a(), along_a(stretch), tolerance);
    });
    std::move(behind, open.end(), std::back_inserter(done));
    open.erase(behind, open.end());
    open.push_back(merged(curves, CurveCluster(stretch), open, tolerance));
  }
  std::move(open.begin(), open.end(), std::back_inserter(done));
  return curves.a.is_closed() ? merged_at_seam(curves, std::move(done), tolerance) : done;
}

bool holds(const CurveCluster& cluster, const TwoCurves& curves, const SpotPair& at, double tolerance) {
  const double a = CurvePieces::place(at.a);
  const double b = CurvePieces::place(at.b);
  return cluster.reaches(curves, {a, a}, {b, b}, tolerance).has_value();
}

ClusterShape shape_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance) {
  constexpr std::size_t kCount = 33;
  // Curves that only touch are nearly a tolerance apart along most of a cluster.
  constexpr double kOne = 0x1p-6;
  std::array<double, kCount> places;
  std::array<double, kCount> distances;
  std::size_t near = 0;
  double length = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    places[i] = cluster.a().start + cluster.a().length() * static_cast<double>(i) / (kCount - 1);
    const SpotPair at = cluster.at(curves, places[i]);
    distances[i] = curves.distance(at);
    near += distances[i] <= kOne * tolerance ? 1 : 0;
    const auto point = [&](std::size_t k) { return curves.a.at(curves.a.spot(places[k])).point; };
    if (i > 0) length += glm::distance(point(i), point(i - 1));
  }
  const auto best = static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
  const bool is_overlap = length > 8.0 * tolerance && 4 * near >= 3 * kCount;
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
  return {is_overlap, cluster.at(curves, place), is_parallel(place)};
}

}  // namespace splinecore
