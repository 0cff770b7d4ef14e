#include "aligned_sections.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "kink.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kPlaces = 128;

/// How much less near than the nearest a beginning may be that is a knot, or where the curve begins already.
constexpr double kAsNear = 1e-12;

/// Even ones of a domain that begins at a parameter; of open curves with both ends.
std::vector<double> places_of(const NurbsCurve& curve, double begin) {
  const Interval domain = curve.domain();
  const int steps = curve.periodic() ? kPlaces : kPlaces - 1;
  std::vector<double> parameters(kPlaces);
  for (int k = 0; k < kPlaces; ++k) parameters[k] = begin + domain.length() * k / steps;
  if (!curve.periodic()) parameters.back() = domain.end;
  return parameters;
}

std::vector<glm::dvec3> points_at(const NurbsCurve& curve, double begin) {
  const std::vector<double> parameters = places_of(curve, begin);
  std::vector<glm::dvec3> points(parameters.size());
  evaluate(curve, parameters, {&points.front().x, 3 * points.size()});
  return points;
}

std::vector<glm::dvec3> about_middle(std::vector<glm::dvec3> points) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : points) middle += p / static_cast<double>(points.size());
  for (glm::dvec3& p : points) p -= middle;
  return points;
}

double product(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

/// Beginnings of a curve, and how near to another one each brings it: the larger, the nearer.
class Beginnings {
 public:
  Beginnings(const std::vector<glm::dvec3>& other, const NurbsCurve& curve) : other_(other), curve_(curve) {}

  double at(double begin) const { return product(other_, points_at(curve_, begin)); }

  /// The beginning that is nearest of even ones, then where the nearness ceases to grow between those beside it.
  double best() const {
    const Interval domain = curve_.domain();
    const std::vector<glm::dvec3> points = points_at(curve_, domain.start);
    int best = 0;
    for (int shift = 1; shift < kPlaces; ++shift) {
      if (turned(points, shift) > turned(points, best)) best = shift;
    }
    const double step = domain.length() / kPlaces;
    double low = domain.start + (best - 1) * step;
    double high = domain.start + (best + 1) * step;
    for (int round = 0; round < 50; ++round) {
      const double middle = 0.5 * (low + high);
      (growth(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  double turned(const std::vector<glm::dvec3>& points, int shift) const {
    double sum = 0.0;
    for (int k = 0; k < kPlaces; ++k) sum += glm::dot(other_[k], points[(k + shift) % kPlaces]);
    return sum;
  }

  double growth(double begin) const {
    const std::vector<double> parameters = places_of(curve_, begin);
    std::vector<double> values(6 * parameters.size());
    derivatives(curve_, parameters, 1, values);
    double sum = 0.0;
    for (std::size_t k = 0; k < other_.size(); ++k) {
      sum += glm::dot(other_[k], glm::dvec3(values[6 * k + 3], values[6 * k + 4], values[6 * k + 5]));
    }
    return sum;
  }

  const std::vector<glm::dvec3>& other_;
  const NurbsCurve& curve_;
};

/// An angle that one sees, and that imports do not make.
constexpr double kSeen = 0.02;

bool begins_at_corner(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  return std::ranges::any_of(corners_above(curve, kSeen), [&](double u) { return u == domain.start || u == domain.end; });
}

struct Beginning {
  double at;
  double nearness;
};

/// How a curve runs best beside the one before it, and the angles by which it is turned from that, as it is and as it runs best.
struct BestTurn {
  SectionTurn turn;
  double angle_as_it_is;
  double angle;
};

Beginning nearest_of(const std::vector<double>& places, const Beginnings& nearness) {
  Beginning best{places.front(), nearness.at(places.front())};
  for (const double place : places) {
    const Beginning one{place, nearness.at(place)};
    if (one.nearness > best.nearness) best = one;
  }
  return best;
}

/// Where a periodic curve best begins. @param size  what nearness is relative to
Beginning beginning_of(const NurbsCurve& curve, const Beginnings& nearness, bool from_corner, double size) {
  const std::vector<double> corners = corners_above(curve, kSeen);
  if (from_corner && !corners.empty()) return nearest_of(corners, nearness);
  const double best = nearness.best();
  const Beginning found{best, nearness.at(best)};
  const double start = curve.domain().start;
  const Beginning as_it_is{start, nearness.at(start)};
  if (as_it_is.nearness >= found.nearness - kAsNear * size) return as_it_is;
  const auto knots = curve.knot_vector().knots();
  const Beginning at_knot = nearest_of({knots.begin(), knots.end() - 1}, nearness);
  return at_knot.nearness >= found.nearness - kAsNear * size ? at_knot : found;
}

double angle_of(double nearness, double size) { return size > 0.0 ? std::acos(std::clamp(nearness / size, -1.0, 1.0)) : 0.0; }

BestTurn best_turn(const NurbsCurve& before, const NurbsCurve& curve) {
  const NurbsCurve other_way = reversed(curve);
  const std::vector<glm::dvec3> other = about_middle(points_at(before, before.domain().start));
  const Beginnings along(other, curve);
  const Beginnings against(other, other_way);
  const std::vector<glm::dvec3> own = about_middle(points_at(curve, curve.domain().start));
  const double size = std::sqrt(product(other, other)) * std::sqrt(product(own, own));
  const double as_it_is = along.at(curve.domain().start);
  if (!curve.periodic()) {
    const double back = against.at(other_way.domain().start);
    const bool is_reversed = back > as_it_is + kAsNear * size;
    return {{is_reversed, {}}, angle_of(as_it_is, size), angle_of(is_reversed ? back : as_it_is, size)};
  }
  const bool from_corner = before.periodic() && begins_at_corner(before);
  const Beginning first = beginning_of(curve, along, from_corner, size);
  const Beginning second = beginning_of(other_way, against, from_corner, size);
  const bool is_reversed = second.nearness > first.nearness + kAsNear * size;
  const Beginning& best = is_reversed ? second : first;
  const double start = (is_reversed ? other_way : curve).domain().start;
  return {{is_reversed, best.at == start ? std::nullopt : std::optional(best.at)}, angle_of(as_it_is, size),
          angle_of(best.nearness, size)};
}

/// Begun later by a part of the domain.
NurbsCurve begun_later(const NurbsCurve& curve, double share) {
  const Interval domain = curve.domain();
  const double by = (share - std::floor(share)) * domain.length();
  return by > 0.0 && by < domain.length() ? with_seam_at(curve, domain.start + by) : curve;
}

}  // namespace

NurbsCurve turned(const NurbsCurve& curve, const SectionTurn& turn) {
  const NurbsCurve run = turn.is_reversed ? reversed(curve) : curve;
  return turn.seam ? with_seam_at(run, *turn.seam) : run;
}

std::vector<SectionTurn> turns_of(const std::vector<NurbsCurve>& curves) {
  std::vector<SectionTurn> turns;
  std::optional<NurbsCurve> before;
  for (const NurbsCurve& curve : curves) {
    turns.push_back(before ? best_turn(*before, curve).turn : SectionTurn{});
    before = turned(curve, turns.back());
  }
  return turns;
}

double turn_left(const NurbsCurve& last, const NurbsCurve& first) {
  constexpr double kSeen = 0.2;      // radians more than need be: less is no harm
  constexpr double kReversed = 1.0;  // few sections about a ring may lie as near the other way round
  const BestTurn closing = best_turn(last, first);
  const double more = closing.angle_as_it_is - closing.angle;
  const SectionTurn& turn = closing.turn;
  if (turn.is_reversed ? more <= kReversed : !turn.seam || more <= kSeen) return 0.0;
  if (turn.is_reversed || (last.periodic() && begins_at_corner(last) && !corners_above(first, kSeen).empty())) {
    throw InvalidShape(
        "going round, the sections come back turned: the last one runs beside the first one as that would run from another "
        "beginning, or backwards. An open loft, or sections that turn by whole turns, can be made; so can they as they are, "
        "unaligned");
  }
  const Interval domain = first.domain();
  const double share = (*turn.seam - domain.start) / domain.length();
  return share - std::round(share);
}

std::vector<NurbsCurve> turned_evenly(const std::vector<NurbsCurve>& curves, double share) {
  std::vector<NurbsCurve> made;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    made.push_back(begun_later(curves[i], -share * static_cast<double>(i) / static_cast<double>(curves.size())));
  }
  return made;
}

}  // namespace splinecore
