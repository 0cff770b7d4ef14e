#include <algorithm>
#include <cmath>

#include "base/sort_by.hpp"
#include "curve_cluster.hpp"
#include "near_space.hpp"
#include "splinecore/meet/intersections.hpp"

namespace splinecore {

namespace {

/// Two curves, or one twice, in a space of their own, and the tolerance there.
class IntersectionSearch {
 public:
  IntersectionSearch(const NurbsCurve& a, const NurbsCurve* b, std::optional<double> tolerance)
      : space_(b ? together(a.points(), b->points()) : std::vector<glm::dvec4>(a.points().begin(), a.points().end())),
        a_(a, space_), domain_a_(a.domain()), domain_b_(b ? b->domain() : a.domain()) {
    if (b) b_.emplace(*b, space_);
    tolerance_ = place_tolerance(space_, tolerance);
  }

  CurveIntersections found() const {
    const PairFindings pairs = b_ ? find_pairs(a_, *b_, tolerance_) : find_own_pairs(a_, tolerance_);
    const std::vector<CurveCluster> clusters = clusters_of(curves(), pairs.stretches, tolerance_);
    CurveIntersections found;
    std::vector<Place> places;
    for (const CurveCluster& cluster : clusters) {
      if (cluster.is_trivial()) continue;
      const ClusterShape shape = shape_of(cluster, curves(), tolerance_);
      if (shape.is_overlap) {
        found.overlaps.push_back(overlap(cluster));
      } else if (curves().distance(shape.at) <= tolerance_) {
        places.push_back({shape.at, shape.touches});
      }
    }
    for (const SpotPair& crossing : pairs.crossings) {
      if (std::ranges::none_of(clusters, [&](const auto& c) { return holds(c, curves(), crossing, tolerance_); })) {
        places.push_back({crossing, false});
      }
    }
    found.places = once_each(std::move(places));
    sort_by(found.overlaps, [](const CurveOverlap& overlap) { return overlap.a.start; });
    return found;
  }

 private:
  struct Place {
    SpotPair at;
    bool touches;
  };

  const CurvePieces& b() const { return b_ ? *b_ : a_; }
  TwoCurves curves() const { return {a_, b()}; }

  std::vector<CurveIntersection> once_each(std::vector<Place> places) const {
    std::vector<CurveIntersection> found;
    std::vector<SpotPair> known;
    const auto rank = [&](const Place& place) { return SortKey{place.touches ? 0.0 : 1.0, curves().distance(place.at)}; };
    sort_by(places, rank);
    for (Place place : places) {
      if (!b_ && a_.are_one(place.at.a, place.at.b, tolerance_)) continue;
      if (!b_ && CurvePieces::place(place.at.a) > CurvePieces::place(place.at.b)) std::swap(place.at.a, place.at.b);
      const bool is_known = std::ranges::any_of(known, [&](const SpotPair& other) {
        return a_.are_one(place.at.a, other.a, tolerance_) && b().are_one(place.at.b, other.b, tolerance_);
      });
      if (is_known) continue;
      known.push_back(place.at);
      found.push_back(intersection(place));
    }
    sort_by(found, [](const CurveIntersection& place) { return SortKey{place.a, place.b}; });
    return found;
  }

  CurveIntersection intersection(const Place& place) const {
    const auto [a, b] = place.at;
    const glm::dvec3 on_a = a_.at(a).point;
    const glm::dvec3 gap = this->b().at(b, on_a).offset;
    return {from_start(a_, domain_a_, a), from_start(this->b(), domain_b_, b), space_.leave(on_a + 0.5 * gap),
            space_.length(glm::length(gap)), place.touches};
  }

  /// Of a curve that ends where it begins the end is the start.
  static double from_start(const CurvePieces& curve, const Interval& domain, const CurveSpot& spot) {
    const double u = curve.parameter(spot);
    return curve.is_closed() && u >= domain.end ? domain.start : u;
  }

  CurveOverlap overlap(const CurveCluster& cluster) const {
    constexpr int kSteps = 64;
    const auto turn_a = static_cast<double>(a_.size());
    const auto turn_b = static_cast<double>(b().size());
    const double length = std::min(cluster.a().length(), turn_a);
    const auto place_b = [&](int i) {
      return CurvePieces::place(cluster.at(curves(), cluster.a().start + length * i / kSteps).b);
    };
    const double start = place_b(0);
    double end = start;
    for (int i = 1; i <= kSteps; ++i) {
      const double step = place_b(i) - end;
      end += b().is_closed() ? step - std::round(step / turn_b) * turn_b : step;
    }
    return {parameters(a_, domain_a_, {cluster.a().start, cluster.a().start + length}),
            parameters(b(), domain_b_, {std::min(start, end), std::max(start, end)}), start > end};
  }

  /// On a closed curve the end may be a turn further.
  static Interval parameters(const CurvePieces& curve, const Interval& domain, const Interval& places) {
    const auto turn = static_cast<double>(curve.size());
    const double before = curve.is_closed() ? std::floor(places.start / turn) * turn : 0.0;
    const double start = places.start - before;
    const double end = places.end - before;
    const bool is_beyond = curve.is_closed() && end > turn;
    const double of_end = curve.parameter(curve.spot(is_beyond ? end - turn : end));
    return {curve.parameter(curve.spot(start)), is_beyond ? of_end + domain.length() : of_end};
  }

  NearSpace space_;
  CurvePieces a_;
  std::optional<CurvePieces> b_;
  Interval domain_a_;
  Interval domain_b_;
  double tolerance_;
};

}  // namespace

CurveIntersections intersections(const NurbsCurve& a, const NurbsCurve& b, std::optional<double> tolerance) {
  return IntersectionSearch(a, &b, tolerance).found();
}

CurveIntersections self_intersections(const NurbsCurve& curve, std::optional<double> tolerance) {
  return IntersectionSearch(curve, nullptr, tolerance).found();
}

}  // namespace splinecore
