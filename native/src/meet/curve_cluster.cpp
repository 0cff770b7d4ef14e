#include "curve_cluster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace splinecore {

namespace {

double place_a(const CurveStretch& s, double t) { return CurvePieces::place({s.piece_a, t}); }
double place_b(const CurveStretch& s, double t) { return CurvePieces::place({s.piece_b, t}); }
Interval along_a(const CurveStretch& s) { return {place_a(s, s.a.start), place_a(s, s.a.end)}; }
Interval along_b(const CurveStretch& s) { return {place_b(s, s.b.start), place_b(s, s.b.end)}; }

Interval joined(const Interval& a, const Interval& b) { return {std::min(a.start, b.start), std::max(a.end, b.end)}; }

/// Whether places of a curve are next to each other, and not farther apart than that.
bool are_beside(const CurvePieces& curve, const Interval& a, const Interval& b, double tolerance) {
  const double before = std::min(a.end, b.end);
  const double behind = std::max(a.start, b.start);
  if (behind <= before) return true;
  constexpr double kNext = 0.5;  // of a piece
  if (behind - before > kNext) return false;
  return glm::length(curve.at(curve.spot(behind), curve.at(curve.spot(before)).point).offset) <= tolerance;
}

/// How curves lie at a pair of places.
struct Crossing {
  glm::dvec3 gap;
  glm::dvec3 normal;  ///< of both tangents, as long as the sine of their angle
};

Crossing crossing_at(const TwoCurves& curves, const SpotPair& at) {
  const Slopes<1> a = curves.a.at(at.a);
  const Slopes<1> b = curves.b.at(at.b, a.point);
  const auto unit = [](const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : v;
  };
  return {b.offset, glm::cross(unit(a.first[0]), unit(b.first[0]))};
}

/// Between two places where a vector has opposite directions the one where it is zero, by halving.
template <class Vector>
double zero_between(Interval in, Vector vector) {
  const glm::dvec3 way = vector(in.end) - vector(in.start);
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) (glm::dot(vector(in.middle()), way) < 0.0 ? in.start : in.end) = in.middle();
  return in.middle();
}

}  // namespace

CurveCluster::CurveCluster(const CurveStretch& first)
    : stretches_{first}, a_(along_a(first)), b_(along_b(first)), is_trivial_(first.is_trivial) {}

bool CurveCluster::reaches(const TwoCurves& curves, const CurveStretch& stretch, double tolerance) const {
  return are_beside(curves.a, a_, along_a(stretch), tolerance) && are_beside(curves.b, b_, along_b(stretch), tolerance);
}

void CurveCluster::add(const CurveStretch& stretch) {
  stretches_.push_back(stretch);
  a_ = joined(a_, along_a(stretch));
  b_ = joined(b_, along_b(stretch));
  is_trivial_ = is_trivial_ || stretch.is_trivial;
}

void CurveCluster::add(const CurveCluster& other) {
  stretches_.insert(stretches_.end(), other.stretches_.begin(), other.stretches_.end());
  a_ = joined(a_, other.a_);
  b_ = joined(b_, other.b_);
  is_trivial_ = is_trivial_ || other.is_trivial_;
}

SpotPair CurveCluster::at(const TwoCurves& curves, double place) const {
  const auto distance_to = [&](const CurveStretch& s) {
    const Interval in = along_a(s);
    return std::max({in.start - place, place - in.end, 0.0});
  };
  const CurveStretch& on = *std::ranges::min_element(stretches_, {}, distance_to);
  const CurveSpot spot{on.piece_a, std::clamp(place - static_cast<double>(on.piece_a), on.a.start, on.a.end)};
  return {spot, {on.piece_b, foot_of(curves.b, on.piece_b, on.b, curves.a.at(spot).point)}};
}

std::vector<CurveCluster> clusters_of(const TwoCurves& curves, std::vector<CurveStretch> stretches, double tolerance) {
  std::ranges::sort(stretches, {}, [](const CurveStretch& s) { return along_a(s).start; });
  std::vector<CurveCluster> done;
  std::vector<CurveCluster> open;
  for (const CurveStretch& stretch : stretches) {
    const auto behind = std::partition(open.begin(), open.end(), [&](const CurveCluster& cluster) {
      return are_beside(curves.a, cluster.a(), along_a(stretch), tolerance);
    });
    std::move(behind, open.end(), std::back_inserter(done));
    open.erase(behind, open.end());
    const auto others = std::partition(open.begin(), open.end(), [&](const CurveCluster& cluster) {
      return !cluster.reaches(curves, stretch, tolerance);
    });
    if (others == open.end()) {
      open.emplace_back(stretch);
      continue;
    }
    others->add(stretch);
    for (auto other = others + 1; other != open.end(); ++other) others->add(*other);
    open.erase(others + 1, open.end());
  }
  std::move(open.begin(), open.end(), std::back_inserter(done));
  return done;
}

bool holds(const CurveCluster& cluster, const TwoCurves& curves, const SpotPair& at, double tolerance) {
  const double a = CurvePieces::place(at.a);
  const double b = CurvePieces::place(at.b);
  return are_beside(curves.a, cluster.a(), {a, a}, tolerance) && are_beside(curves.b, cluster.b(), {b, b}, tolerance);
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
    if (i > 0) length += glm::distance(curves.a.at(curves.a.spot(places[i])).point, curves.a.at(curves.a.spot(places[i - 1])).point);
  }
  const auto best = static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
  const bool is_overlap = length > 8.0 * tolerance && 4 * near >= 3 * kCount;
  const auto gap = [&](double place) { return crossing_at(curves, cluster.at(curves, place)).gap; };
  const auto normal = [&](double place) { return crossing_at(curves, cluster.at(curves, place)).normal; };
  const Interval around{places[best == 0 ? 0 : best - 1], places[std::min(best + 1, kCount - 1)]};
  double place = places[best];
  if (glm::dot(gap(places.front()), gap(places.back())) < 0.0) {
    place = zero_between({places.front(), places.back()}, gap);
  } else if (glm::dot(normal(around.start), normal(around.end)) < 0.0) {
    place = zero_between(around, normal);
  }
  const double sine = glm::length(normal(place));
  const double sine_at_ends = std::max(glm::length(normal(places.front())), glm::length(normal(places.back())));
  constexpr double kParallel = 1e-6;
  return {is_overlap, cluster.at(curves, place), sine <= std::max(0.5 * sine_at_ends, kParallel)};
}

}  // namespace splinecore
