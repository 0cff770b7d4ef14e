#include "own_overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/sort_by.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr int kSamples = 16;

/// Whether a curve stays within a distance of a place from there to another one, of a closed curve either way.
bool stays_within(const CurvePieces& curve, double from, double to, double distance) {
  const glm::dvec3 start = curve.at(curve.spot(from)).point;
  const auto is_within = [&](double place) {
    return glm::length(curve.at(curve.spot(place), start).offset) <= distance;
  };
  if (!is_within(to)) return false;
  const double turn = curve.is_closed() ? curve.turn() : 0.0;
  const double direct = turn > 0.0 ? std::remainder(to - from, turn) : to - from;
  const auto goes = [&](double by) {
    for (int i = 1; i < kSamples; ++i) {
      if (!is_within(from + by * i / kSamples)) return false;
    }
    return true;
  };
  return goes(direct) || (turn > 0.0 && goes(direct > 0.0 ? direct - turn : direct + turn));
}

class Overlaps {
 public:
  Overlaps(std::vector<LaidOverlap> overlaps, const TwoCurves& curves, double tolerance)
      : overlaps_(std::move(overlaps)), curves_(curves), tolerance_(tolerance) {}

  std::vector<LaidOverlap> own() {
    while (join_some()) {
    }
    drop_parts();
    return std::move(overlaps_);
  }

 private:
  static double end_of_b(const LaidOverlap& o) { return o.is_reversed ? o.b.start : o.b.end; }
  static double start_of_b(const LaidOverlap& o) { return o.is_reversed ? o.b.end : o.b.start; }

  bool join_some() {
    sort_by(overlaps_, [](const LaidOverlap& o) { return SortKey{o.a.start, o.a.end}; });
    std::vector<bool> is_joined(overlaps_.size(), false);
    bool has_joined = false;
    for (std::size_t i = 0; i < overlaps_.size(); ++i) {
      if (is_joined[i]) continue;
      const double far = kTurnsBack * tolerance_;
      const double first = overlaps_[i].a.end - curves_.a.reach(overlaps_[i].a.end, -1.0, far);
      const double last = overlaps_[i].a.end + curves_.a.reach(overlaps_[i].a.end, 1.0, far);
      const auto begin = std::ranges::lower_bound(overlaps_, first, {}, [](const LaidOverlap& o) { return o.a.start; });
      for (auto j = static_cast<std::size_t>(begin - overlaps_.begin()); j < overlaps_.size(); ++j) {
        if (overlaps_[j].a.start > last) break;
        if (j == i || is_joined[j] || !does_go_on(overlaps_[i], overlaps_[j])) continue;
        append(overlaps_[i], overlaps_[j]);
        is_joined[j] = has_joined = true;
        break;
      }
    }
    std::size_t i = 0;
    std::erase_if(overlaps_, [&](const LaidOverlap&) { return is_joined[i++]; });
    return has_joined;
  }

  /// Whether one overlap goes on in another one: ends are near along both curves, which stay beside each other there.
  bool does_go_on(const LaidOverlap& one, const LaidOverlap& next) const {
    if (one.is_reversed != next.is_reversed) return false;
    if (!(one.a.start < next.a.start && one.a.end < next.a.end)) return false;
    const bool is_ahead = one.is_reversed ? next.b.start < one.b.start && next.b.end < one.b.end
                                          : next.b.start > one.b.start && next.b.end > one.b.end;
    const double far = kTurnsBack * tolerance_;
    return is_ahead && stays_within(curves_.a, one.a.end, next.a.start, far) &&
           stays_within(curves_.b, end_of_b(one), start_of_b(next), far) &&
           are_beside(curves_.a, one.a.end, next.a.start, curves_.b, end_of_b(one), start_of_b(next)) &&
           are_beside(curves_.b, end_of_b(one), start_of_b(next), curves_.a, one.a.end, next.a.start);
  }

  /// Whether a curve from one place to another one is beside the other curve around the same.
  bool are_beside(const CurvePieces& curve, double from, double to, const CurvePieces& other, double other_from,
                  double other_to) const {
    constexpr int kFine = 8 * kSamples;
    const double low = std::min(other_from, other_to);
    const double high = std::max(other_from, other_to);
    const double far = kTurnsBack * tolerance_;
    const Interval around{low - other.reach(low, -1.0, far), high + other.reach(high, 1.0, far)};
    std::array<glm::dvec3, kFine + 1> beside;
    for (int k = 0; k <= kFine; ++k) {
      beside[static_cast<std::size_t>(k)] = other.at(other.spot(around.start + around.length() * k / kFine)).point;
    }
    for (int i = 0; i <= kSamples; ++i) {
      const glm::dvec3 point = curve.at(curve.spot(std::lerp(from, to, static_cast<double>(i) / kSamples))).point;
      double least = glm::distance(point, beside.back());
      for (std::size_t k = 0; k < kFine; ++k) least = std::min(least, distance_to(point, beside[k], beside[k + 1]));
      if (!(least <= kBeside * tolerance_)) return false;
    }
    return true;
  }

  static double distance_to(const glm::dvec3& point, const glm::dvec3& start, const glm::dvec3& end) {
    const glm::dvec3 along = end - start;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - start, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, start + share * along);
  }

  static void append(LaidOverlap& one, const LaidOverlap& next) {
    one.a.end = next.a.end;
    one.b = {std::min(one.b.start, next.b.start), std::max(one.b.end, next.b.end)};
    one.clusters.insert(one.clusters.end(), next.clusters.begin(), next.clusters.end());
  }

  /// Of overlaps the ones that are beside a longer one all along go.
  void drop_parts() {
    std::vector<SortKey> keys;
    for (const LaidOverlap& o : overlaps_) keys.push_back({-length_of(o)});
    const std::vector<std::size_t> order = order_of(keys);
    const std::vector<std::vector<std::size_t>> longer = longer_beside(order);
    std::vector<bool> is_part(overlaps_.size(), false);
    for (const std::size_t i : order) {
      is_part[i] = std::ranges::any_of(longer[i], [&](std::size_t whole) {
        return !is_part[whole] && is_part_of(overlaps_[i], overlaps_[whole]);
      });
    }
    std::size_t i = 0;
    std::erase_if(overlaps_, [&](const LaidOverlap&) { return is_part[i++]; });
  }

  /// Of each overlap the ones before it in an order that it may be a part of: along the first curve each is compared
  /// with those that are not yet behind, of a closed curve on its next turn, too.
  std::vector<std::vector<std::size_t>> longer_beside(const std::vector<std::size_t>& order) const {
    struct Laid {
      std::size_t overlap;
      Interval wide;
    };
    const double far = kOwn * tolerance_;
    std::vector<std::size_t> rank(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
    std::vector<Laid> all;
    for (std::size_t i = 0; i < overlaps_.size(); ++i) {
      const Interval& a = overlaps_[i].a;
      const Interval wide{a.start - curves_.a.reach(a.start, -1.0, far), a.end + curves_.a.reach(a.end, 1.0, far)};
      all.push_back({i, wide});
      const double turn = curves_.a.turn();
      if (curves_.a.is_closed()) all.push_back({i, {wide.start + turn, wide.end + turn}});
    }
    sort_by(all, [](const Laid& laid) { return laid.wide.start; });
    std::vector<std::vector<std::size_t>> longer(overlaps_.size());
    std::vector<Laid> open;
    for (const Laid& laid : all) {
      breathe(16 * (open.size() + 1));
      std::erase_if(open, [&](const Laid& other) { return other.wide.end < laid.wide.start; });
      for (const Laid& other : open) {
        if (other.overlap == laid.overlap) continue;
        const bool is_shorter = rank[laid.overlap] > rank[other.overlap];
        const std::size_t part = is_shorter ? laid.overlap : other.overlap;
        const std::size_t whole = is_shorter ? other.overlap : laid.overlap;
        if (may_be_beside(overlaps_[part], overlaps_[whole])) longer[part].push_back(whole);
      }
      open.push_back(laid);
    }
    return longer;
  }

  double length_of(const LaidOverlap& o) const {
    double length = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const auto point = [&](int k) {
        return curves_.a.at(curves_.a.spot(o.a.start + o.a.length() * k / kSamples)).point;
      };
      length += glm::distance(point(i), point(i + 1));
    }
    return length;
  }

  bool is_part_of(const LaidOverlap& part, const LaidOverlap& whole) const {
    constexpr int kPlaces = 4;
    breathe(64);
    for (int i = 0; i <= kPlaces; ++i) {
      const double a = part.a.start + part.a.length() * i / kPlaces;
      // What fills a hole of the longer one goes its way from one of its places to another.
      const bool fills = i > 0 && i < kPlaces && part.is_reversed == whole.is_reversed && !holds(whole, a);
      if (!fills && !is_beside(a, curves_.b.place(at(part, a, curves_).b), whole, curves_, kOwn * tolerance_)) {
        return false;
      }
    }
    return true;
  }

  bool holds(const LaidOverlap& o, double place) const {
    return std::ranges::any_of(o.clusters, [&](const CurveCluster* c) { return c->holds(curves_, place); });
  }

  bool may_be_beside(const LaidOverlap& part, const LaidOverlap& whole) const {
    return is_middle_near(curves_.a, part.a, whole.a) && is_middle_near(curves_.b, part.b, whole.b);
  }

  bool is_middle_near(const CurvePieces& curve, const Interval& part, const Interval& whole) const {
    const double place = part.middle();
    const double in = std::clamp(place, whole.start, whole.end);
    if (in == place || curve.is_closed()) return true;
    return glm::length(curve.at(curve.spot(in), curve.at(curve.spot(place)).point).offset) <= kOwn * tolerance_;
  }

 public:
  static SpotPair at(const LaidOverlap& o, double place, const TwoCurves& curves) {
    const auto beyond = [&](const CurveCluster* cluster) {
      return std::max({cluster->a().start - place, place - cluster->a().end, 0.0});
    };
    return (*std::ranges::min_element(o.clusters, {}, beyond))->at(curves, place);
  }

  /// Whether a pair of places is no farther than that along both curves from one of an overlap.
  static bool is_beside(double a, double b, const LaidOverlap& whole, const TwoCurves& curves, double far) {
    const double turn = curves.a.is_closed() ? curves.a.turn() : 0.0;
    for (const double by : {0.0, turn, -turn}) {
      const auto [on_a, on_b] = curves.places(at(whole, std::clamp(a + by, whole.a.start, whole.a.end), curves));
      if (stays_within(curves.a, a, on_a, far) && stays_within(curves.b, b, on_b, far)) return true;
      if (turn == 0.0) break;
    }
    return false;
  }

 private:
  /// Tolerances, as what is found is looked at within them, and some for samples.
  static constexpr double kBeside = 1.5;

  std::vector<LaidOverlap> overlaps_;
  TwoCurves curves_;
  double tolerance_;
};

}  // namespace

std::vector<LaidOverlap> own_overlaps(std::vector<LaidOverlap> overlaps, const TwoCurves& curves, double tolerance) {
  return overlaps.size() < 2 ? overlaps : Overlaps(std::move(overlaps), curves, tolerance).own();
}

bool is_of_any(const std::vector<LaidOverlap>& overlaps, const SpotPair& at, const TwoCurves& curves,
               double tolerance) {
  const auto [a, b] = curves.places(at);
  return std::ranges::any_of(overlaps, [&](const LaidOverlap& o) {
    breathe(64);
    const double in = std::clamp(a, o.a.start, o.a.end);
    if (!stays_within(curves.a, a, in, kOwn * tolerance)) return false;
    const double beside = curves.b.place(Overlaps::at(o, in, curves).b);
    return stays_within(curves.b, b, beside, kOwn * tolerance) &&
           are_joined(curves, {a, b}, {in, beside}, kOfOverlap * tolerance);
  });
}

}  // namespace splinecore
