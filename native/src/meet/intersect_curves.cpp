#include <algorithm>
#include <cmath>

#include "base/sort_by.hpp"
#include "curve_cluster.hpp"
#include "near_space.hpp"
#include "own_overlaps.hpp"
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
    const double wide = kWide * tolerance_;
    const PairFindings pairs = b_ ? find_pairs(a_, *b_, wide) : find_own_pairs(a_, wide);
    CurveIntersections found;
    std::vector<Place> places;
    std::vector<LaidOverlap> overlaps;
    const std::vector<CurveCluster> clusters = clusters_of(curves(), pairs, tolerance_);
    for (const CurveCluster& cluster : clusters) {
      const ClusterShape shape = shape_of(cluster, curves(), tolerance_);
      if (shape.overlap) {
        overlaps.push_back(overlap(cluster, *shape.overlap));
      } else if (shape.at && !cluster.is_trivial()) {
        places.push_back({*shape.at, shape.touches});
      }
    }
    overlaps = own_overlaps(std::move(overlaps), curves(), tolerance_);
    std::erase_if(places, [&](const Place& p) { return is_of_any(overlaps, p.at, curves(), tolerance_); });
    found.places = once_each(std::move(places));
    if (!b_ && a_.is_closed()) join_over_the_end(overlaps);
    for (const LaidOverlap& o : overlaps) {
      found.overlaps.push_back({parameters(a_, domain_a_, o.a), parameters(b(), domain_b_, o.b), o.is_reversed});
    }
    sort_by(found.overlaps, [](const CurveOverlap& overlap) { return overlap.a.start; });
    return found;
  }

 private:
  struct Place {
    SpotPair at;
    bool touches;
  };

  const CurvePieces& b() const { return b_ ? *b_ : a_; }
  TwoCurves curves() const { return {a_, b(), space_.rounding()}; }

  /// Of places that are one, along the first curve next to each other, the one that curves touch at, or are nearest.
  std::vector<CurveIntersection> once_each(std::vector<Place> places) const {
    if (!b_) {
      for (Place& p : places) {
        if (a_.place(p.at.a) > a_.place(p.at.b)) std::swap(p.at.a, p.at.b);
      }
      std::erase_if(places, [&](const Place& p) { return is_neighborhood(p.at); });
    }
    sort_by(places, [&](const Place& p) { return SortKey{a_.place(p.at.a), b().place(p.at.b)}; });
    std::vector<Place> known;
    std::vector<std::size_t> open;
    const auto take = [&](const Place& place) {
      const double at = a_.place(place.at.a);
      std::erase_if(open, [&](std::size_t i) {
        const double from = a_.place(known[i].at.a);
        return at - from > a_.reach(from, 1.0, tolerance_);
      });
      const auto same = std::ranges::find_if(open, [&](std::size_t i) { return are_one(known[i], place); });
      if (same == open.end()) {
        open.push_back(known.size());
        known.push_back(place);
      } else if (is_before(place, known[*same])) {
        known[*same] = place;
      }
    };
    for (const Place& place : places) take(place);
    join_at_seams(known);
    std::vector<CurveIntersection> found;
    found.reserve(known.size());
    for (const Place& place : known) found.push_back(intersection(place));
    sort_by(found, [](const CurveIntersection& place) { return SortKey{place.a, place.b}; });
    return found;
  }

  /// Whether the curve goes from one of two places of it to the other, or over its end, without leaving itself by more than
  /// the tolerance, as at a cusp.
  bool is_neighborhood(const SpotPair& at) const {
    if (a_.are_one(at.a, at.b, tolerance_)) return true;
    const double low = a_.place(at.a);
    const double high = a_.place(at.b);
    if (turns_back(a_, low, high, tolerance_)) return true;
    return a_.is_closed() && turns_back(a_, high, low + a_.turn(), tolerance_);
  }

  bool are_one(const Place& one, const Place& other) const {
    return a_.are_one(one.at.a, other.at.a, tolerance_) && b().are_one(one.at.b, other.at.b, tolerance_);
  }

  bool is_before(const Place& one, const Place& other) const {
    if (one.touches != other.touches) return one.touches;
    return curves().distance(one.at) < curves().distance(other.at);
  }

  /// Of a closed curve places next to its end are those next to its start.
  void join_at_seams(std::vector<Place>& places) const {
    if (!a_.is_closed() || places.empty()) return;
    const double far_at_start = a_.reach(0.0, 1.0, 2.0 * tolerance_);
    const double far_at_end = a_.turn() - a_.reach(0.0, -1.0, 2.0 * tolerance_);
    std::vector<std::size_t> starts;
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool is_end = a_.place(places[i].at.a) >= far_at_end || (!b_ && a_.place(places[i].at.b) >= far_at_end);
      if (is_end) ends.push_back(i);
      if (a_.place(places[i].at.a) <= far_at_start) starts.push_back(i);
    }
    std::vector<bool> is_double(places.size(), false);
    for (const std::size_t start : starts) {
      for (const std::size_t end : ends) {
        if (start == end || is_double[start] || is_double[end]) continue;
        const Place swapped{{places[end].at.b, places[end].at.a}, places[end].touches};
        if (!are_one(places[start], places[end]) && (b_ || !are_one(places[start], swapped))) continue;
        is_double[is_before(places[end], places[start]) ? start : end] = true;
      }
    }
    std::size_t i = 0;
    std::erase_if(places, [&](const Place&) { return is_double[i++]; });
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

  LaidOverlap overlap(const CurveCluster& cluster, const Interval& along) const {
    constexpr int kSteps = 64;
    const double turn_b = b().turn();
    const bool is_round = cluster.is_round(curves());
    const double from = is_round ? 0.0 : along.start;
    const double length = is_round ? a_.turn() : along.length();
    const auto place_b = [&](int i) {
      return b().place(cluster.at(curves(), from + length * i / kSteps).b);
    };
    const double start = place_b(0);
    double end = start;
    Interval beside{start, start};
    for (int i = 1; i <= kSteps; ++i) {
      const double step = place_b(i) - end;
      end += b().is_closed() ? step - std::round(step / turn_b) * turn_b : step;
      beside = {std::min(beside.start, end), std::max(beside.end, end)};
    }
    return {{from, from + length}, beside, start > end, {&cluster}};
  }

  /// Of a closed curve with itself an overlap with one of its stretches to the end, and one from the start that goes on
  /// where the former stops, are one.
  void join_over_the_end(std::vector<LaidOverlap>& overlaps) const {
    const auto joined_with_any = [&](std::size_t i) {
      for (std::size_t j = 0; j < overlaps.size(); ++j) {
        const auto both = i == j ? std::nullopt : joined(overlaps[i], overlaps[j]);
        if (!both) continue;
        overlaps[std::min(i, j)] = *both;
        overlaps.erase(overlaps.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
        return true;
      }
      return false;
    };
    for (std::size_t i = 0; i < overlaps.size();) i = joined_with_any(i) ? 0 : i + 1;
  }

  std::optional<LaidOverlap> joined(const LaidOverlap& before, const LaidOverlap& after) const {
    if (before.is_reversed != after.is_reversed) return {};
    const auto are_one_place = [&](double p, double q) {
      return a_.are_one(a_.spot(p), a_.spot(q), kWide * tolerance_);
    };
    for (const LaidOverlap& x : {before, before.swapped()}) {
      for (const LaidOverlap& y : {after, after.swapped()}) {
        if (!are_one_place(x.a.end, 0.0) || !are_one_place(y.a.start, 0.0)) continue;
        if (!are_one_place(x.is_reversed ? x.b.start : x.b.end, x.is_reversed ? y.b.end : y.b.start)) continue;
        const Interval over{x.a.start, a_.turn() + y.a.end};
        const Interval beside = x.is_reversed ? Interval{y.b.start, x.b.end} : Interval{x.b.start, y.b.end};
        if (beside.start >= beside.end || over.length() > a_.turn()) continue;
        return over.start < beside.start ? LaidOverlap{over, beside, x.is_reversed}
                                         : LaidOverlap{beside, over, x.is_reversed};
      }
    }
    return {};
  }

  /// On a closed curve the end may be a turn further.
  static Interval parameters(const CurvePieces& curve, const Interval& domain, const Interval& places) {
    const double turn = curve.turn();
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
