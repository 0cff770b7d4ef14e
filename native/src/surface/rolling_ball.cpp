#include "rolling_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "fillet_between.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/evaluate.hpp"
#include "splinecore/surface/extend_patch.hpp"

namespace splinecore {

namespace {

/// How far, by the radius, patches go on beyond the ends of their edge: where sides slant, contacts lie farther out.
constexpr double kBeyond = 2.0;

/// Whether a patch that was made longer is still where it was beside the side: rational ones may have huge points then, which cancel.
bool stays(const NurbsPatch& wide, const NurbsPatch& patch, Border side) {
  constexpr double kRounding = 0x1p-42;
  const std::vector<double> knots = inner_knots(patch.knot_vector(Axis::u));
  const Interval u = patch.knot_vector(Axis::u).domain();
  const Interval v = patch.knot_vector(Axis::v).domain();
  const bool is_start = side == Border::u_start;
  const double end = is_start ? u.start : u.end;
  const double next = knots.empty() ? (is_start ? u.end : u.start) : (is_start ? knots.front() : knots.back());
  for (const double share : {0.0, 0.25, 0.5, 0.75}) {
    for (const double at : {v.start, 0.5 * (v.start + v.end), v.end}) {
      const glm::dvec2 place(std::lerp(end, next, share), at);
      glm::dvec3 before;
      glm::dvec3 behind;
      evaluate(patch, std::span(&place.x, 1), std::span(&place.y, 1), std::span(&before.x, 3));
      evaluate(wide, std::span(&place.x, 1), std::span(&place.y, 1), std::span(&behind.x, 3));
      if (!(distance_of(before, behind) <= kRounding)) return false;
    }
  }
  return true;
}

/// Sides that cross the edge are moved out, for balls that touch a patch a little beyond them; less where digits are lost, and where
/// that cannot be, not.
NurbsPatch widened(const NurbsPatch& patch, double length) {
  constexpr int kTries = 4;
  NurbsPatch wide = patch;
  if (patch.knot_vector(Axis::u).periodic()) return wide;
  for (const Border side : {Border::u_start, Border::u_end}) {
    for (int k = 0; k < kTries; ++k) {
      try {
        NurbsPatch longer = extended(wide, side, std::ldexp(length, -2 * k));
        if (!stays(longer, patch, side)) continue;
        wide = std::move(longer);
        break;
      } catch (const InvalidShape&) {
        continue;
      }
    }
  }
  return wide;
}

/// A place of a patch with its unit normal, and how both change.
struct TouchedPlace {
  glm::dvec3 point;
  glm::dvec3 along_u;
  glm::dvec3 along_v;
  glm::dvec3 normal;
  glm::dvec3 normal_u;
  glm::dvec3 normal_v;
};

TouchedPlace touched(const NurbsPatch& patch, const glm::dvec2& at) {
  std::array<glm::dvec3, 9> d;
  derivatives(patch, std::span(&at.x, 1), std::span(&at.y, 1), 2, std::span(&d.front().x, 27));
  const glm::dvec3 cross = glm::cross(d[3], d[1]);
  const double length = length_of(cross);
  const glm::dvec3 normal = cross / length;
  const auto change = [&](const glm::dvec3& by) { return (by - glm::dot(by, normal) * normal) / length; };
  return {d[0], d[3], d[1], normal, change(glm::cross(d[6], d[1]) + glm::cross(d[3], d[4])),
          change(glm::cross(d[4], d[1]) + glm::cross(d[3], d[2]))};
}

/// At right angles to the edge, into the patch.
glm::dvec3 inwards(const TouchedPlace& place) {
  const glm::dvec3 in = place.along_v - glm::dot(place.along_v, place.along_u) / glm::dot(place.along_u, place.along_u) * place.along_u;
  return in / length_of(in);
}

glm::dvec2 inside(const NurbsPatch& patch, glm::dvec2 at) {
  const Interval u = patch.knot_vector(Axis::u).domain();
  const Interval v = patch.knot_vector(Axis::v).domain();
  if (!patch.knot_vector(Axis::u).periodic()) at.x = std::clamp(at.x, u.start, u.end);
  at.y = std::clamp(at.y, v.start, v.end);
  return at;
}

}  // namespace

RollingBall::RollingBall(const NurbsPatch& first, const NurbsPatch& second, const NumbersAlong& radii,
                         const std::optional<RimPlaces>& rims)
    : first_(widened(first, kBeyond * radii.largest())), second_(widened(second, kBeyond * radii.largest())), radii_(radii), rims_(rims) {
  constexpr double kFlat = 1e-6;
  constexpr int kSteps = 16;
  double seen_at = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    const double u = static_cast<double>(k) / kSteps;
    const TouchedPlace a = touched(first_, {u, first_.knot_vector(Axis::v).domain().start});
    const TouchedPlace b = touched(second_, {rims_ ? rims_->on_second(u) : u, second_.knot_vector(Axis::v).domain().start});
    const double toward_b = glm::dot(a.normal, inwards(b));
    const double toward_a = glm::dot(b.normal, inwards(a));
    if (!(std::abs(toward_b) > kFlat && std::abs(toward_a) > kFlat)) continue;
    const double side = toward_b > 0.0 ? 1.0 : -1.0;
    if (side_of_first_ == 0.0) seen_at = u;
    if (side_of_first_ == -side) {
      throw InvalidShape("the edge turns from an inner one to an outer one between " + text_of(seen_at) + " and " + text_of(u) +
                         " of it: no ball rolls along it on one side");
    }
    seen_at = u;
    side_of_first_ = side;
    side_of_second_ = toward_a > 0.0 ? 1.0 : -1.0;
  }
  if (side_of_first_ == 0.0) {
    throw InvalidShape("the patches have one tangent plane along their edge: there is nothing to round");
  }
}

/// As if both were planes.
Contact RollingBall::start(double u, bool is_of_first) const {
  const double on_first = rims_ && !is_of_first ? rims_->on_first(u) : u;
  const double on_second = rims_ && is_of_first ? rims_->on_second(u) : u;
  const double start_a = first_.knot_vector(Axis::v).domain().start;
  const double start_b = second_.knot_vector(Axis::v).domain().start;
  const TouchedPlace a = touched(first_, inside(first_, {on_first, start_a}));
  const TouchedPlace b = touched(second_, inside(second_, {on_second, start_b}));
  const double radius = radii_.at(std::clamp(on_first, 0.0, 1.0));
  const double half = 0.5 * std::acos(std::clamp(glm::dot(inwards(a), inwards(b)), -1.0, 1.0));
  const double away = radius / std::tan(half);
  Contact contact{};
  contact.on_first = inside(first_, {on_first, start_a + away / length_of(a.along_v)});
  contact.on_second = inside(second_, {on_second, start_b + away / length_of(b.along_v)});
  return contact;
}

std::vector<BallJoint> RollingBall::joints() const {
  std::vector<BallJoint> found;
  for (const double knot : inner_knots(first_.knot_vector(Axis::u))) found.push_back({knot, "a knot of the first patch"});
  for (const double knot : inner_knots(second_.knot_vector(Axis::u))) {
    found.push_back({at(knot, false).on_first.x, "a knot of the second patch"});
  }
  for (const double given : radii_.joints()) found.push_back({given, "a radius that is given"});
  if (first_.knot_vector(Axis::u).periodic()) {
    for (BallJoint& joint : found) joint.at -= std::floor(joint.at);
  }
  std::ranges::stable_sort(found, {}, &BallJoint::at);
  return found;
}

std::vector<double> RollingBall::between(double from, double to, std::span<const double> shares) const {
  if (rims_) return rims_->between(from, to, shares);
  std::vector<double> found(shares.begin(), shares.end());
  for (double& share : found) share = std::lerp(from, to, share);
  return found;
}

/// The ball touches what it leaves behind in the circle (p - c) c' = -r r' (Monge): its plane is off the center where r changes.
void RollingBall::tilt(Contact& contact, double u) const {
  contact.circle_center = contact.center;
  contact.circle_radius = contact.radius;
  const double growth = radii_.slope_beyond(u);
  if (growth == 0.0) return;
  const TouchedPlace a = touched(first_, contact.on_first);
  const TouchedPlace b = touched(second_, contact.on_second);
  const double ra = side_of_first_ * contact.radius;
  const double rb = side_of_second_ * contact.radius;
  const glm::dvec3 across = a.along_v + ra * a.normal_v;
  const glm::dvec3 onwards = a.along_u + ra * a.normal_u + growth * side_of_first_ * a.normal;
  const glm::dmat3 jacobian(across, -(b.along_u + rb * b.normal_u), -(b.along_v + rb * b.normal_v));
  const glm::dvec3 change = onwards - growth * side_of_second_ * b.normal;
  const glm::dvec3 way = onwards - (glm::inverse(jacobian) * change).x * across;
  const double square = glm::dot(way, way);
  const double inside = 1.0 - growth * growth / square;
  if (!(inside > 0.0)) {
    throw InvalidShape("the radius changes so fast at " + text_of(u) + " of the edge that the ball there lies inside those beside it");
  }
  contact.circle_center = contact.center - contact.radius * growth / square * way;
  contact.circle_radius = contact.radius * std::sqrt(inside);
}

Contact RollingBall::at(double u, bool is_of_first) const {
  constexpr int kRounds = 50;
  constexpr double kReached = 1e-14;
  Contact contact = start(u, is_of_first);
  const NurbsPatch& fixed = is_of_first ? first_ : second_;
  const NurbsPatch& other = is_of_first ? second_ : first_;
  glm::dvec2 on_fixed = is_of_first ? contact.on_first : contact.on_second;
  glm::dvec2 on_other = is_of_first ? contact.on_second : contact.on_first;
  const double side_fixed = is_of_first ? side_of_first_ : side_of_second_;
  const double side_other = is_of_first ? side_of_second_ : side_of_first_;
  double left = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    contact.radius = radii_.beyond(is_of_first ? u : on_other.x);
    const TouchedPlace a = touched(fixed, on_fixed);
    const TouchedPlace b = touched(other, on_other);
    const double ra = side_fixed * contact.radius;
    const double rb = side_other * contact.radius;
    const glm::dvec3 center = a.point + ra * a.normal;
    const glm::dvec3 off = center - (b.point + rb * b.normal);
    left = length_of(off);
    (is_of_first ? contact.first : contact.second) = a.point;
    (is_of_first ? contact.second : contact.first) = b.point;
    contact.center = center - 0.5 * off;
    (is_of_first ? contact.on_first : contact.on_second) = on_fixed;
    (is_of_first ? contact.on_second : contact.on_first) = on_other;
    if (left <= kReached) break;
    const double growth = is_of_first ? 0.0 : radii_.slope_beyond(on_other.x);
    const glm::dvec3 grown = growth * (side_fixed * a.normal - side_other * b.normal);
    const glm::dmat3 jacobian(a.along_v + ra * a.normal_v, grown - (b.along_u + rb * b.normal_u), -(b.along_v + rb * b.normal_v));
    const double determinant = glm::determinant(jacobian);
    if (determinant == 0.0 || !std::isfinite(determinant)) break;
    const glm::dvec3 step = glm::inverse(jacobian) * off;
    on_fixed = inside(fixed, {on_fixed.x, on_fixed.y - step.x});
    on_other = inside(other, {on_other.x - step.y, on_other.y - step.z});
  }
  constexpr double kNear = 1e-11;
  if (left <= kNear) {
    if (is_of_first) tilt(contact, u);
    return contact;
  }
  throw InvalidShape("a ball of the radius does not touch both patches at " + text_of(u) + " of the edge: it is too large, or they end before");
}

}  // namespace splinecore
