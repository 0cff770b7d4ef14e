#include "splinecore/build/joint_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "joint_order.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = length_of(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

bool was_moved(const JointSide& side, std::size_t i) { return !side.moved.empty() && side.moved[i]; }

/// What both sides agree on.
glm::dvec3 agreed(const glm::dvec3& first, const glm::dvec3& second, JoinMoves moves) {
  if (moves == JoinMoves::both) return 0.5 * first + 0.5 * second;
  return moves == JoinMoves::second ? first : second;
}

/// The first two derivatives of a side, its first span taken for 1, by points about the joint, of which the largest is about 1.
class LeavingCurve {
 public:
  LeavingCurve(const JointSide& side, const glm::dvec3& joint, double scale, int order)
      : degree_(side.degree), second_span_(side.second_span / side.first_span), joint_(joint), scale_(scale), rows_(side.points) {
    const glm::dvec3 way = joint - glm::dvec3(rows_[0]);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      glm::dvec4& row = rows_[i];
      const bool goes_along = row.w != 0.0 && static_cast<int>(i) <= order && !was_moved(side, i);
      if (goes_along) row += glm::dvec4(way, 0.0);
      places_.push_back((row.w != 0.0 ? (glm::dvec3(row) - joint) * row.w : glm::dvec3(row)) / scale);
    }
    rows_[0] = glm::dvec4(joint, rows_[0].w);
    places_[0] = glm::dvec3(0.0);
    given_ = places_;
    read();
  }

  const glm::dvec3& velocity() const { return velocity_; }
  const glm::dvec3& acceleration() const { return acceleration_; }

  glm::dvec3 curvature() const {
    const glm::dvec3 tangent = unit(velocity_);
    return (acceleration_ - glm::dot(acceleration_, tangent) * tangent) / glm::dot(velocity_, velocity_);
  }

  /// Where no second derivative is given, the points behind the first stay.
  void set(const glm::dvec3& velocity, const std::optional<glm::dvec3>& acceleration) {
    const double w = rows_[0].w;
    const double p = degree_;
    places_[1] = w * velocity / p;
    if (acceleration) {
      const glm::dvec3 bend = w * *acceleration + 2.0 * slope_ * velocity;
      places_[2] = places_[1] + second_span_ * (bend / (p * (p - 1.0)) + places_[1]);
    }
    read();
  }

  std::vector<glm::dvec4> points() const {
    std::vector<glm::dvec4> points = rows_;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (places_[i] == given_[i]) continue;
      const glm::dvec3 place = places_[i] * scale_;
      const double w = points[i].w;
      points[i] = glm::dvec4(w != 0.0 ? joint_ + place / w : place, w);
    }
    for (const glm::dvec4& point : points) {
      if (!is_finite(glm::dvec3(point))) throw InvalidShape("a point beside the joint would leave the range of numbers");
    }
    return points;
  }

 private:
  void read() {
    const double p = degree_;
    const auto point = [&](int i) { return glm::dvec4(places_[i], rows_[i].w); };
    const glm::dvec4 one = p * (point(1) - point(0));
    glm::dvec4 two(0.0);
    if (degree_ > 1) two = p * (p - 1.0) * ((point(2) - point(1)) / second_span_ - (point(1) - point(0)));
    slope_ = one.w;
    velocity_ = glm::dvec3(one) / rows_[0].w;
    acceleration_ = (glm::dvec3(two) - 2.0 * slope_ * velocity_) / rows_[0].w;
  }

  int degree_;
  double second_span_;
  glm::dvec3 joint_;
  double scale_;
  std::vector<glm::dvec4> rows_;
  std::vector<glm::dvec3> places_;  // times their weights, about the joint
  std::vector<glm::dvec3> given_;
  double slope_ = 0.0;              // of the weights
  glm::dvec3 velocity_{0.0};
  glm::dvec3 acceleration_{0.0};
};

/// @param ratio  the first span of the second side by that of the first
void make_parametric(LeavingCurve& first, LeavingCurve& second, double ratio, JoinMoves moves, int order) {
  const glm::dvec3 velocity = agreed(-first.velocity() * ratio, second.velocity(), moves);
  const glm::dvec3 acceleration = agreed(first.acceleration() * ratio * ratio, second.acceleration(), moves);
  const bool bends = order == 2;
  if (moves != JoinMoves::second) first.set(-velocity / ratio, bends ? std::optional(acceleration / ratio / ratio) : std::nullopt);
  if (moves != JoinMoves::first) second.set(velocity, bends ? std::optional(acceleration) : std::nullopt);
}

/// Give a side a tangent and a curvature vector; its speed stays, and how that changes.
void bend(LeavingCurve& side, const glm::dvec3& tangent, const std::optional<glm::dvec3>& curvature) {
  const double speed = length_of(side.velocity());
  if (!curvature) return side.set(speed * tangent, std::nullopt);
  const double along = glm::dot(side.acceleration(), unit(side.velocity()));
  const glm::dvec3 across = *curvature - glm::dot(*curvature, tangent) * tangent;
  side.set(speed * tangent, speed * speed * across + along * tangent);
}

void make_geometric(LeavingCurve& first, LeavingCurve& second, JoinMoves moves, int order) {
  const auto has_direction = [](const LeavingCurve& side) { return glm::dot(side.velocity(), side.velocity()) > 0.0; };
  if (!has_direction(first) || !has_direction(second)) return;
  const glm::dvec3 before = -unit(first.velocity());
  glm::dvec3 tangent = unit(agreed(before, unit(second.velocity()), moves));
  if (tangent == glm::dvec3(0.0)) tangent = before;  // they go back the way they came: neither is nearer
  std::optional<glm::dvec3> curvature;
  if (order == 2) curvature = agreed(first.curvature(), second.curvature(), moves);
  if (moves != JoinMoves::second) bend(first, -tangent, curvature);
  if (moves != JoinMoves::first) bend(second, tangent, curvature);
}

void require_side(const JointSide& side, const char* name, bool gives_way, int order) {
  const std::string of = std::string(name) + " side of the joint ";
  if (side.degree < 1) throw InvalidShape("the " + of + "has degree " + std::to_string(side.degree) + ": 1 or more is expected");
  const std::size_t least = side.degree > 1 ? 3 : 2;
  if (side.points.size() < least || side.points.size() > 3) {
    throw InvalidShape("the " + of + "has " + std::to_string(side.points.size()) + " points: of degree " +
                       std::to_string(side.degree) + " the first " + (least == 2 ? "2 or 3" : "3") + " are expected");
  }
  for (const glm::dvec4& point : side.points) {
    if (!is_finite(glm::dvec3(point)) || !std::isfinite(point.w)) throw InvalidShape("a point of the " + of + "is not finite");
  }
  if (side.points[0].w == 0.0) throw InvalidShape("the joint lies at infinity");
  if (!(side.first_span > 0.0 && side.second_span >= side.first_span && std::isfinite(side.second_span))) {
    throw InvalidShape("the spans of the " + of + "are " + text_of(side.first_span) + " and " + text_of(side.second_span) +
                       ": they start above 0 and do not decrease");
  }
  if (!side.moved.empty() && side.moved.size() != side.points.size()) {
    throw InvalidShape("the " + of + "says of " + std::to_string(side.moved.size()) + " points whether they were moved, and has " +
                       std::to_string(side.points.size()));
  }
  if (gives_way && side.degree < order) {
    throw InvalidShape("the " + of + "has degree " + std::to_string(side.degree) + ", which is too low for the continuity: raise it first");
  }
}

glm::dvec3 start_of(const JointSide& first, const JointSide& second, JoinMoves moves) {
  const bool leads = was_moved(first, 0);
  if (leads != was_moved(second, 0)) moves = leads ? JoinMoves::second : JoinMoves::first;
  return agreed(glm::dvec3(first.points[0]), glm::dvec3(second.points[0]), moves);
}

/// How far points lie from the joint; 1 where all are there.
double reach_of(const JointSide& first, const JointSide& second, const glm::dvec3& joint) {
  double reach = 0.0;
  for (const JointSide* const side : {&first, &second}) {
    for (const glm::dvec4& point : side->points) {
      const glm::dvec3 away = glm::abs(glm::dvec3(point) - (point.w != 0.0 ? joint : glm::dvec3(0.0)));
      reach = std::max({reach, away.x, away.y, away.z});
    }
  }
  return reach > 0.0 ? reach : 1.0;
}

}  // namespace

JointPoints joint_points(const JointSide& first, const JointSide& second, PatchSmoothness smoothness, JoinMoves moves) {
  const int order = order_of(smoothness);
  require_side(first, "first", moves != JoinMoves::second, order);
  require_side(second, "second", moves != JoinMoves::first, order);
  const glm::dvec3 joint = start_of(first, second, moves);
  const double reach = reach_of(first, second, joint);
  LeavingCurve before(first, joint, reach, order);
  LeavingCurve after(second, joint, reach, order);
  if (is_parametric(smoothness)) make_parametric(before, after, second.first_span / first.first_span, moves, order);
  if (!is_parametric(smoothness) && order > 0) make_geometric(before, after, moves, order);
  return {before.points(), after.points()};
}

}  // namespace splinecore
