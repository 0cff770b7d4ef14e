#include "splinecore/measure/moving_frame.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "carried_frames.hpp"
#include "finite_weights.hpp"
#include "frenet_frame.hpp"
#include "near_curve.hpp"
#include "splinecore/base/approximation.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/continuity.hpp"
#include "splinecore/measure/length.hpp"

namespace splinecore {

namespace {

using Vector = glm::dvec3;

/// What of a vector is at right angles to a unit one.
Vector across(const Vector& v, const Vector& tangent) { return v - glm::dot(v, tangent) * tangent; }

Vector reflected(const Vector& v, const Vector& mirror) {
  return v - (2.0 * glm::dot(v, mirror) / glm::dot(mirror, mirror)) * mirror;
}

/// A unit vector at right angles to a unit tangent, turned about it.
Vector turned(const Vector& normal, const Vector& tangent, double angle) {
  return std::cos(angle) * normal + std::sin(angle) * glm::cross(tangent, normal);
}

/// The angle about the tangent from one vector at right angles to it to another.
double angle_from(const Vector& a, const Vector& b, const Vector& tangent) {
  return std::atan2(glm::dot(glm::cross(a, b), tangent), glm::dot(a, b));
}

/// By the least turn that takes one tangent to the other; where that is no plane's, as at a cusp, the normal stays.
Vector bent(const Vector& normal, const Vector& from, const Vector& to) {
  constexpr double kReversed = 0x1p-20;
  const Vector middle = from + to;
  const Vector moved = glm::length(middle) > kReversed ? reflected(normal, middle) : normal;
  return glm::normalize(across(moved, to));
}

/// A place of the curve.
struct CurvePlace {
  double u;
  Vector point;
  Vector tangent;
};

/// Where a step begins, and the normal there.
struct CarriedStep {
  CurvePlace from;
  Vector normal;
};

/// A normal that is carried along one span after the other.
class Carrier {
 public:
  Carrier(const NurbsCurve& curve, const SlowPlaces& slow, const std::optional<Vector>& start)
      : curve_(curve), slow_(slow), step_(0x1p-22 * extent(curve.points())) {
    const int spans = static_cast<int>(curve.knot_vector().spans().size());
    for (int span = 0; span < spans && !is_number(tangent_); ++span) {
      tangent_ = tangent_at(curve.knot_vector().span_interval(span).start, Side::right, span);
    }
    if (!is_number(tangent_)) throw InvalidShape("the curve is a point: it has no tangent");
    normal_ = start ? given_normal(*start) : own_normal();
  }

  /// Carries the normal along the next span. @returns the steps it took
  std::vector<CarriedStep> pass() {
    const Interval range = curve_.knot_vector().span_interval(span_);
    CurvePlace from = place_at(range.start, span_, tangent_);
    normal_ = bent(normal_, tangent_, from.tangent);
    tangent_ = from.tangent;
    halvings_ = 0;
    std::vector<CarriedStep> steps;
    for (Steps at = 0; at < kAllSteps;) {
      steps.push_back({from, normal_});
      const CurvePlace to = take_step(from, at, range, span_);
      normal_ = carried(normal_, from, to, span_).first;
      tangent_ = to.tangent;
      from = to;
    }
    ++span_;
    return steps;
  }

  /// The frame at a parameter of a span that was passed.
  MovingFrame frame_at(double u, int span, const std::vector<CarriedStep>& steps) const {
    const auto next = std::ranges::upper_bound(steps, u, {}, [](const CarriedStep& step) { return step.from.u; });
    const CarriedStep& step = *(next == steps.begin() ? next : next - 1);
    const CurvePlace place = place_at(u, span, step.from.tangent);
    return frame_of(place.tangent, carried(step.normal, step.from, place, span).first);
  }

  MovingFrame frame() const { return frame_of(tangent_, normal_); }

 private:
  /// The smallest that a span is cut into.
  using Steps = std::int64_t;
  static constexpr int kDeepest = 40;
  static constexpr Steps kAllSteps = Steps{1} << kDeepest;

  static bool is_number(const Vector& v) { return std::isfinite(v.x); }

  static MovingFrame frame_of(const Vector& tangent, const Vector& normal) {
    return {tangent, normal, glm::cross(tangent, normal)};
  }

  Side side_in(double u, int span) const {
    return u == curve_.knot_vector().span_interval(span).end ? Side::left : Side::right;
  }

  Vector tangent_at(double u, Side side, int span, Vector* point = nullptr) const {
    breathe(256);
    std::array<Vector, 2> values;
    derivatives(curve_, {&u, 1}, 1, std::span(&values[0].x, 6), {.side = side});
    if (point) *point = values[0];
    const bool is_slow = slow_.is_slow(values[1], curve_.knot_vector().span_interval(span).length());
    return is_slow ? frenet_frame(curve_, slow_, u, side).tangent : glm::normalize(values[1]);
  }

  /// @param way_in  the tangent where the curve stands still
  CurvePlace place_at(double u, int span, const Vector& way_in) const {
    CurvePlace place{u, Vector(0.0), Vector(0.0)};
    place.tangent = tangent_at(u, side_in(u, span), span, &place.point);
    if (!is_number(place.tangent)) place.tangent = way_in;
    return place;
  }

  Vector given_normal(const Vector& start) const {
    constexpr double kParallel = 0x1p-30;
    const double size = std::max({std::abs(start.x), std::abs(start.y), std::abs(start.z)});
    const Vector normal = size > 0.0 ? across(start / size, tangent_) : Vector(0.0);
    if (!(glm::length(normal) > kParallel)) {
      throw InvalidShape("start has no part at right angles to the tangent of the curve's start");
    }
    return glm::normalize(across(glm::normalize(normal), tangent_));
  }

  /// Whether the curve bends at a place by more than noise of its points does.
  bool is_bent(double at) const {
    constexpr double kNoise = 1e-6;
    std::array<Vector, 3> jet;
    derivatives(curve_, {&at, 1}, 2, {&jet[0].x, 9}, {.side = Side::right});
    const double speed = glm::length(jet[1]);
    return !(glm::length(glm::cross(jet[1], jet[2])) * extent(curve_.points()) <= kNoise * speed * speed * speed);
  }

  Vector own_normal() const {
    const double start = curve_.domain().start;
    const MovingFrame frenet = frenet_frame(curve_, slow_, start, Side::right);
    if (is_number(frenet.normal) && is_bent(start)) return frenet.normal;
    int least = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(tangent_[axis]) < std::abs(tangent_[least])) least = axis;
    }
    Vector axis(0.0);
    axis[least] = 1.0;
    return glm::normalize(across(axis, tangent_));
  }

  /// One double reflection.
  Vector step(const Vector& normal, const CurvePlace& from, const CurvePlace& to) const {
    const Vector chord = to.point - from.point;
    if (!(glm::length(chord) > step_)) return bent(normal, from.tangent, to.tangent);
    const Vector mirrored = reflected(normal, chord);
    const Vector mirror = to.tangent - reflected(from.tangent, chord);
    const Vector moved = glm::dot(mirror, mirror) > 0.0 ? reflected(mirrored, mirror) : mirrored;
    return glm::normalize(across(moved, to.tangent));
  }

  /// The normal carried from one place to another, and the angle by which two halves of the step change it: more than
  /// any where the curve bends too much to tell.
  std::pair<Vector, double> carried(const Vector& normal, const CurvePlace& from, const CurvePlace& to,
                                    int span) const {
    constexpr double kStraight = 0.9;
    constexpr double kUnknown = 4.0;
    const double u = from.u + 0.5 * (to.u - from.u);
    if (!(u > from.u && u < to.u)) return {step(normal, from, to), 0.0};
    const CurvePlace middle = place_at(u, span, from.tangent);
    const Vector whole = step(normal, from, to);
    const Vector halves = step(step(normal, from, middle), middle, to);
    const double change = angle_from(whole, halves, to.tangent);
    const bool is_straight = glm::dot(from.tangent, middle.tangent) > kStraight &&
                             glm::dot(middle.tangent, to.tangent) > kStraight;
    // The error of a step grows with the fifth power of its length.
    return {is_straight ? turned(halves, to.tangent, change / 15.0) : halves,
            is_straight ? std::abs(change) : kUnknown};
  }

  /// Goes on by one step: spans are halved, at least so often that no symmetry hides anything, and at most to where a
  /// cusp is.
  /// @throws ToleranceNotReached where a span takes too many.
  CurvePlace take_step(const CurvePlace& from, Steps& at, const Interval& range, int span) {
    constexpr double kEnough = 1e-10;
    constexpr int kMostHalvings = 1 << 17;
    const int most = at == 0 ? kDeepest : std::countr_zero(static_cast<std::uint64_t>(at));
    for (int size = std::min(most, kDeepest - least_depth());; --size) {
      const Steps end = at + (Steps{1} << size);
      const double part = static_cast<double>(end) / static_cast<double>(kAllSteps);
      const CurvePlace to = place_at(std::lerp(range.start, range.end, part), span, from.tangent);
      const double change = size > 0 ? carried(normal_, from, to, span).second : 0.0;
      if (change > kEnough) {
        if (++halvings_ < kMostHalvings) continue;
        throw ToleranceNotReached("the frames cannot be carried along the curve", kEnough, change);
      }
      at = end;
      return to;
    }
  }

  int least_depth() const { return 2 + std::ilogb(static_cast<double>(curve_.degree())); }

  const NurbsCurve& curve_;
  const SlowPlaces& slow_;
  int span_ = 0;      ///< the next one
  int halvings_ = 0;  ///< of steps on it
  double step_;   ///< a chord that is no longer has a direction that rounding shows
  Vector tangent_{std::numeric_limits<double>::quiet_NaN()};
  Vector normal_{0.0};
};

/// A frame that is asked for.
struct Query {
  int span;
  double u;
  std::size_t index;
};

/// A frame at the end is that which was carried there, also of a periodic curve, which begins there again.
Side side_of(const KnotVector& knots, double u, Side side) { return u == knots.domain().end ? Side::left : side; }

std::vector<Query> queries_of(const NearCurve& near, const KnotVector& knots, std::span<const double> parameters,
                              Side side) {
  std::vector<Query> queries;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Side from = side_of(knots, parameters[i], side);
    const double u = std::scalbn(knots.admit(parameters[i], from, i), -near.parameters);
    queries.push_back({near.curve.knot_vector().span_of(u, from), u, i});
  }
  std::ranges::sort(queries, {}, [](const Query& q) { return std::tuple(q.span, q.u, q.index); });
  return queries;
}

void require_smooth_end(const NurbsCurve& curve, const MovingFrame& start, const MovingFrame& end) {
  if (!is_closed(curve)) throw InvalidShape("the curve is not closed: its frames cannot be");
  if (glm::length(start.tangent - end.tangent) <= kContinuityTolerance) return;
  throw InvalidShape("the curve has a corner where it closes: its frames cannot be closed");
}

/// Takes back, evenly by length, what the frame has turned by at the end.
void close_frames(const NurbsCurve& curve, std::span<const double> parameters, Side side, double angle,
                  std::span<MovingFrame> out) {
  const std::vector<double> lengths = lengths_at_parameters(curve, parameters);
  const double end = curve.domain().end;
  const double whole = length(curve, curve.domain(), kPlaceTolerance).value;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool is_end = curve.knot_vector().admit(parameters[i], side_of(curve.knot_vector(), parameters[i], side), i) == end;
    MovingFrame& frame = out[i];
    frame.normal = turned(frame.normal, frame.tangent, angle * (is_end ? 1.0 : lengths[i] / whole));
    frame.binormal = glm::cross(frame.tangent, frame.normal);
  }
}

}  // namespace

class CarriedFrames::Carried {
 public:
  Carried(const NurbsCurve& curve, const CarriedFrame& how)
      : curve_(curve), how_(how), near_(near_of(curve)), slow_(curve, near_), carrier_(near_.curve, slow_, how.start),
        first_(carrier_.frame()) {}

  void write(std::span<const double> parameters, std::span<MovingFrame> out, Side side) {
    const std::vector<Query> queries = queries_of(near_, curve_.knot_vector(), parameters, side);
    const int all = static_cast<int>(near_.curve.knot_vector().spans().size());
    carry(how_.is_closed ? all : queries.empty() ? 0 : queries.back().span + 1);
    for (const Query& query : queries) {
      out[query.index] = carrier_.frame_at(query.u, query.span, steps_[static_cast<std::size_t>(query.span)]);
    }
    if (!how_.is_closed) return;
    const MovingFrame last = carrier_.frame();
    require_smooth_end(curve_, first_, last);
    close_frames(curve_, parameters, side, angle_from(last.normal, first_.normal, first_.tangent), out);
  }

 private:
  static NearCurve near_of(const NurbsCurve& curve) {
    require_finite_points(curve, curve.domain());
    return near_origin(curve);
  }

  void carry(int spans) {
    while (static_cast<int>(steps_.size()) < spans) steps_.push_back(carrier_.pass());
  }

  NurbsCurve curve_;
  CarriedFrame how_;
  NearCurve near_;
  SlowPlaces slow_;
  Carrier carrier_;
  MovingFrame first_;
  std::vector<std::vector<CarriedStep>> steps_;  ///< of the spans that were passed
};

CarriedFrames::CarriedFrames(const NurbsCurve& curve, const CarriedFrame& how)
    : carried_(std::make_unique<Carried>(curve, how)) {}

CarriedFrames::~CarriedFrames() = default;

void CarriedFrames::write(std::span<const double> parameters, std::span<MovingFrame> out, Side side) {
  carried_->write(parameters, out, side);
}

void rotation_minimizing_frames(const NurbsCurve& curve, std::span<const double> parameters,
                                std::span<MovingFrame> out, const CarriedFrame& how, Side side) {
  CarriedFrames(curve, how).write(parameters, out, side);
}

}  // namespace splinecore
