#include "curve_approach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/rounding.hpp"


namespace splinecore {

namespace {

/// How two curves lie at a pair of places: b - a, and the derivatives.
struct Approach {
  glm::dvec3 gap;
  glm::dvec3 a;
  glm::dvec3 b;

  double square() const noexcept { return glm::dot(gap, gap); }
};

Approach approach_at(const TwoCurves& curves, const SpotPair& at) {
  const Slopes<1> a = curves.a.at(at.a);
  const Slopes<1> b = curves.b.at(at.b, a.point);
  return {b.offset, a.first[0], b.first[0]};
}

/// By how much both parameters go to where straight lines with these tangents are nearest.
std::array<double, 2> steps_of(const Approach& now) {
  const double aa = glm::dot(now.a, now.a);
  const double bb = glm::dot(now.b, now.b);
  const glm::dvec3 normal = glm::cross(now.a, now.b);
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0)) {
    // Parallel ones: one of them goes to the foot of the other's point.
    if (!(aa > 0.0) && !(bb > 0.0)) return {0.0, 0.0};
    if (aa >= bb) return {glm::dot(now.gap, now.a) / aa, 0.0};
    return {0.0, -glm::dot(now.gap, now.b) / bb};
  }
  return {glm::dot(glm::cross(now.gap, now.b), normal) / square, glm::dot(glm::cross(now.gap, now.a), normal) / square};
}

/// Steps that leave their ranges go along the border.
void hold_at_borders(const Approach& now, const std::array<double, 2>& at, const std::array<Interval, 2>& ranges,
                     std::array<double, 2>& steps) {
  const auto is_held = [&](int k) {
    return (at[k] <= ranges[k].start && steps[k] < 0.0) || (at[k] >= ranges[k].end && steps[k] > 0.0);
  };
  const bool hold_a = is_held(0);
  const bool hold_b = is_held(1);
  const double aa = glm::dot(now.a, now.a);
  const double bb = glm::dot(now.b, now.b);
  if (hold_a) steps = {0.0, bb > 0.0 ? -glm::dot(now.gap, now.b) / bb : 0.0};
  if (hold_b) steps = {aa > 0.0 ? glm::dot(now.gap, now.a) / aa : 0.0, 0.0};
  for (int k = 0; k < 2; ++k) {
    if (is_held(k)) steps[k] = 0.0;
  }
}

/// A gap less what a parameter of the curve along it is rounded by.
glm::dvec3 less_rounding(const glm::dvec3& gap, const glm::dvec3& along) noexcept {
  const double square = glm::dot(along, along);
  if (!(square > 0.0) || !std::isfinite(square)) return gap;
  return gap - std::clamp(glm::dot(gap, along) / square, -kRoundingOfStep, kRoundingOfStep) * along;
}

struct Descent {
  SpotPair at;
  bool has_converged;
};

Descent descended(const TwoCurves& curves, SpotPair at, const Interval& range_a, const Interval& range_b) {
  constexpr int kMost = 60;
  constexpr double kStill = 0x1p-52;
  const std::array<Interval, 2> ranges{range_a, range_b};
  Approach now = approach_at(curves, at);
  for (int round = 0; round < kMost; ++round) {
    std::array<double, 2> steps = steps_of(now);
    hold_at_borders(now, {at.a.t, at.b.t}, ranges, steps);
    bool is_lower = false;
    double share = 1.0;
    for (int halving = 0; halving < 8 && !is_lower; ++halving, share *= 0.5) {
      SpotPair next = at;
      next.a.t = std::clamp(at.a.t + share * steps[0], range_a.start, range_a.end);
      next.b.t = std::clamp(at.b.t + share * steps[1], range_b.start, range_b.end);
      const double moved = std::max(std::abs(next.a.t - at.a.t), std::abs(next.b.t - at.b.t));
      if (moved <= kStill) return {at, true};
      const Approach then = approach_at(curves, next);
      is_lower = then.square() < now.square();
      if (!is_lower) continue;
      at = next;
      now = then;
    }
    if (!is_lower) return {at, true};  // nothing but rounding is left
  }
  return {at, false};
}

/// To the piece beyond the end that it is at; whether there is one.
bool hop(const CurvePieces& curve, CurveSpot& spot) {
  if (spot.t == 1.0) {
    if (const auto next = curve.after(spot.piece)) {
      spot = {*next, 0.0};
      return true;
    }
  } else if (spot.t == 0.0) {
    if (const auto next = curve.before(spot.piece)) {
      spot = {*next, 1.0};
      return true;
    }
  }
  return false;
}

}  // namespace

double TwoCurves::distance(const SpotPair& at) const {
  const Slopes<1> on_a = a.at(at.a);
  const Slopes<1> on_b = b.at(at.b, on_a.point);
  const glm::dvec3 gap = less_rounding(less_rounding(on_b.offset, on_a.first[0]), on_b.first[0]);
  return std::max(glm::length(gap) - a.rounding(at.a, on_a) - b.rounding(at.b, on_b), 0.0);
}

std::optional<SpotPair> nearest_pair(const TwoCurves& curves, SpotPair at, const Interval& range_a,
                                     const Interval& range_b) {
  const Descent found = descended(curves, at, range_a, range_b);
  if (!found.has_converged) return {};
  return found.at;
}

SpotPair settled(const TwoCurves& curves, SpotPair at) {
  constexpr int kMostHops = 64;
  const Interval whole;
  at = descended(curves, at, whole, whole).at;
  double least = curves.distance(at);
  for (int hops = 0; hops < kMostHops; ++hops) {
    SpotPair best = at;
    for (int which = 1; which < 4; ++which) {
      SpotPair other = at;
      const bool a_hops = (which & 1) != 0 && hop(curves.a, other.a);
      const bool b_hops = (which & 2) != 0 && hop(curves.b, other.b);
      if (a_hops != ((which & 1) != 0) || b_hops != ((which & 2) != 0)) continue;
      other = descended(curves, other, whole, whole).at;
      const double distance = curves.distance(other);
      if (!(distance < least)) continue;
      least = distance;
      best = other;
    }
    const bool is_moved = best.a.piece != at.a.piece || best.b.piece != at.b.piece;
    at = best;
    if (!is_moved) break;
  }
  return at;
}

namespace {

/// Of a curve the place between two others at which it goes neither to a point nor away, by halving.
double foot_between(const CurvePieces& curve, double low, double high, const glm::dvec3& point) {
  constexpr int kHalvings = 52;
  for (int i = 0; i < kHalvings && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    const Slopes<1> s = curve.at(curve.spot(middle), point);
    (glm::dot(s.offset, s.first[0]) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Places from one to another one at which a curve is looked at: evenly in each piece, and beyond the other places of it where it
/// is the same curve, for along those it is beside itself.
std::vector<double> places_between(const CurvePieces& curve, double from, double to, std::array<double, 2> others) {
  constexpr int kPlaces = 16;
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  std::vector<double> ends{low, high};
  const auto add = [&](double place) {
    if (low < place && place < high) ends.push_back(place);
  };
  for (const double other : others) add(other);
  for (double end = curve.end_behind(low); end < high; end = curve.end_behind(end)) add(end);
  std::ranges::sort(ends);
  std::vector<double> places;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (i > 1) places.push_back(ends[i - 1]);
    for (int k = 1; k < kPlaces; ++k) places.push_back(std::lerp(ends[i - 1], ends[i], static_cast<double>(k) / kPlaces));
  }
  return places;
}

}  // namespace

bool are_joined(const TwoCurves& curves, const std::array<double, 2>& from, const std::array<double, 2>& to,
                double distance) {
  const bool is_one = &curves.a == &curves.b;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    if (from[k] == to[k]) continue;
    const CurvePieces& curve = k == 0 ? curves.a : curves.b;
    const CurvePieces& other = k == 0 ? curves.b : curves.a;
    const double low = std::min(from[1 - k], to[1 - k]);
    const double high = std::max(from[1 - k], to[1 - k]);
    const std::array<double, 2> others = is_one ? std::array{low, high} : std::array{from[k], to[k]};
    const auto is_near = [&](double place) {
      const glm::dvec3 point = curve.at(curve.spot(place)).point;
      return glm::length(other.at(other.spot(foot_between(other, low, high, point)), point).offset) <= distance;
    };
    if (!std::ranges::all_of(places_between(curve, from[k], to[k], others), is_near)) return false;
  }
  return true;
}

bool turns_back(const CurvePieces& curve, double low, double high, double distance) {
  constexpr int kPlaces = 32;
  constexpr int kThirds = 64;
  const glm::dvec3 from = curve.at(curve.spot(low)).point;
  const auto far = [&](double place) { return glm::length(curve.at(curve.spot(place), from).offset); };
  const double step = (high - low) / kPlaces;
  double farthest = low;
  for (int i = 1; i < kPlaces; ++i) {
    const double place = low + step * i;
    if (far(place) > far(farthest)) farthest = place;
  }
  // What is nearer than a step at most is the only place that is farthest.
  Interval in{std::max(farthest - step, low), std::min(farthest + step, high)};
  const TwoCurves twice{curve, curve};
  if (!are_joined(twice, {low, high}, {in.start, in.end}, distance)) return false;
  for (int i = 0; i < kThirds; ++i) {
    const double first = in.start + in.length() / 3.0;
    const double second = in.end - in.length() / 3.0;
    if (far(first) < far(second)) {
      in.start = first;
    } else {
      in.end = second;
    }
  }
  return are_joined(twice, {low, high}, {in.middle(), in.middle()}, distance);
}

namespace {

/// How a part of a piece leaves an end of it: away from a point, or beside it; nearer to it; or hardly, as rounding has it.
enum class EndSlope { away, nearer, still };

EndSlope slope_at_end(const CurvePieces& curve, std::size_t piece, const Interval& range, bool is_end, const glm::dvec3& point) {
  constexpr double kStill = 0x1p-44;
  const CurveSpot end{piece, is_end ? range.end : range.start};
  const Slopes<1> s = curve.at(end, point);
  const double speed = glm::length(s.first[0]);
  if (speed * range.length() <= kStill || curve.is_rounding(speed, end)) return EndSlope::still;
  const double slope = glm::dot(s.offset, s.first[0]);
  return (is_end ? slope <= 0.0 : slope >= 0.0) ? EndSlope::away : EndSlope::nearer;
}

/// Of a part that goes nearer to a point and then away, by Newton's method in the bracket.
double foot_inside(const CurvePieces& curve, std::size_t piece, const Interval& range, const glm::dvec3& point) {
  constexpr int kMost = 100;
  double low = range.start;
  double high = range.end;
  double t = range.middle();
  for (int round = 0; round < kMost; ++round) {
    const Slopes<1> s = curve.at({piece, t}, point);
    const double slope = glm::dot(s.offset, s.first[0]);
    (slope < 0.0 ? low : high) = t;
    double next = t - slope / (glm::dot(s.first[0], s.first[0]) + glm::dot(s.offset, s.second[0]));
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 0x1p-52 || high - low <= 0x1p-52) return next;
    t = next;
  }
  return t;
}

}  // namespace

double foot_of(const CurvePieces& curve, std::size_t piece, const Interval& range, const glm::dvec3& point) {
  const EndSlope start = slope_at_end(curve, piece, range, false, point);
  if (start == EndSlope::away) return range.start;
  const EndSlope end = slope_at_end(curve, piece, range, true, point);
  if (end == EndSlope::away) return range.end;
  const double foot = foot_inside(curve, piece, range, point);
  // Where the curve hardly moves an end is as near but for rounding.
  const auto far = [&](double t) { return glm::length(curve.at({piece, t}, point).offset); };
  if (start == EndSlope::still && far(range.start) <= far(foot) + kRoundingOfStep) return range.start;
  if (end == EndSlope::still && far(range.end) <= far(foot) + kRoundingOfStep) return range.end;
  return foot;
}

}  // namespace splinecore
