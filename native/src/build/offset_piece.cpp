#include "offset_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "cubics_along.hpp"
#include "slope_parts.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// So much of a length of about 1 is rounding.
constexpr double kPieceRounding = 0x1p-44;

/// The point and two derivatives.
std::array<glm::dvec3, 3> derivatives_at(const BezierCurve& curve, double t) {
  std::array<glm::dvec3, 3> found;
  derivatives(curve.nurbs(), std::span(&t, 1), 2, std::span(&found[0].x, 9));
  return found;
}

glm::dvec4 moved(const glm::dvec4& p, const glm::dvec3& by) { return {glm::dvec3(p) + by, p.w}; }

/// A straight piece is moved as it is.
std::optional<BezierCurve> moved_line(const BezierCurve& curve, const SideStep& step) {
  const auto points = curve.points();
  const glm::dvec3 chord = glm::dvec3(points.back()) - glm::dvec3(points.front());
  const double length = glm::length(chord);
  if (!(length > 0.0)) return {};
  glm::dvec3 before = glm::dvec3(points.front());
  for (const glm::dvec4& p : points) {
    const glm::dvec3 from_start = glm::dvec3(p) - glm::dvec3(points.front());
    const bool is_beside = glm::length(glm::cross(from_start, chord)) > kPieceRounding * length;
    if (!(p.w > 0.0) || is_beside || glm::dot(glm::dvec3(p) - before, chord) < 0.0) return {};
    before = glm::dvec3(p);
  }
  const glm::dvec3 by = step.distance * glm::cross(step.normal, chord / length);
  std::vector<glm::dvec4> made;
  for (const glm::dvec4& p : points) made.push_back(moved(p, by));
  return BezierCurve::make(std::move(made));
}

/// An arc of a circle is blown up from its center. @returns its pieces, none if it is no arc
std::optional<std::vector<BezierCurve>> scaled_arc(const BezierCurve& curve, const SideStep& step) {
  constexpr int kPlaces = 7;
  if (!curve.nurbs().rational()) return {};
  glm::dvec3 center(0.0);
  double radius = 0.0;
  for (int i = 0; i <= kPlaces; ++i) {
    const auto [point, first, second] = derivatives_at(curve, static_cast<double>(i) / kPlaces);
    const double speed = glm::length(first);
    const double turn = glm::dot(glm::cross(first, second), step.normal);
    if (!(std::abs(turn) > 0.0)) return {};
    const glm::dvec3 to_center = speed * speed / turn * glm::cross(step.normal, first);
    if (i == 0) {
      center = point + to_center;
      const bool is_left = glm::dot(to_center, glm::cross(step.normal, first)) > 0.0;
      radius = is_left ? glm::length(to_center) : -glm::length(to_center);
    }
    if (glm::distance(point + to_center, center) > kPieceRounding * (1.0 + std::abs(radius))) return {};
  }
  const double share = (radius - step.distance) / radius;
  if (std::abs(share * radius) <= kPieceRounding) return std::vector<BezierCurve>{};
  std::vector<glm::dvec4> made;
  for (const glm::dvec4& p : curve.points()) {
    const glm::dvec3 at(p);
    made.push_back(p.w == 0.0 ? glm::dvec4(share * at, 0.0) : glm::dvec4(center + share * (at - center), p.w));
  }
  return std::vector{BezierCurve::make(std::move(made))};
}

/// Near an end at which a piece stands still first derivatives are rounding: it goes as far as the second one takes it.
/// @returns none elsewhere
std::optional<glm::dvec3> way_from_still_end(const BezierCurve& curve, double t, double speed, double second) {
  constexpr double kStill = 1e-10;
  const double rounding = 0x1p-50 * curve.degree() * curve.degree();
  if (speed > std::max(kStill * second, std::sqrt(rounding * second))) return {};
  const double end = t < 0.5 ? 0.0 : 1.0;
  if (glm::length(derivatives_at(curve, end)[1]) > std::max(kStill * second, rounding)) return {};
  const glm::dvec3 between = derivatives_at(curve, 0.5 * (t + end))[2];
  const double length = glm::length(between);
  return length > 0.0 ? (t < 0.5 ? 1.0 : -1.0) / length * between : glm::dvec3(0.0);
}

class PieceOffset {
 public:
  PieceOffset(const BezierCurve& curve, const SideStep& step) : curve_(curve), step_(step) {}

  std::vector<BezierCurve> made() {
    std::vector<double> cuts{0.0};
    constexpr int kDepth = 12;
    for (const Interval& part : parts_that_matter(curve_, step_.normal, kDepth, [&](const SlopePart& one) { return may_turn(one); })) {
      if (const auto cusp = cusp_between(part.start, part.end)) cuts.push_back(*cusp);
    }
    cuts.push_back(1.0);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i + 1] - cuts[i] > 0x1p-40) fit(cuts[i], cuts[i + 1]);
    }
    return std::move(made_);
  }

 private:
  /// Whether the offset may turn back on a part: where 1 is the distance times the curvature.
  bool may_turn(const SlopePart& part) const {
    const auto [least, most] = part.slope_lengths();
    const auto [low, high] = part.bend.range();
    const auto [light, heavy] = part.weight.range();
    if (!(light > 0.0)) return true;
    const double bends[] = {step_.distance * low, step_.distance * high};
    const auto of = [](double bend, double small, double large) {
      return bend * (bend > 0.0 ? large * large * large : small * small * small);
    };
    const double bent_most = of(std::max(bends[0], bends[1]), light, heavy);
    const double bent_least = of(std::min(bends[0], bends[1]), heavy, light);
    return least * least * least <= bent_most && most * most * most >= bent_least;
  }

  double stretch(double t) const { return offset_place(curve_, t, step_).stretch; }

  std::optional<double> cusp_between(double low, double high) const {
    const bool rises = stretch(low) < 0.0;
    if (rises == (stretch(high) < 0.0)) return {};
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      ((stretch(middle) < 0.0) == rises ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  void fit(double from, double to) {
    const Path path = [&](const std::vector<PathParameter>& asked) {
      std::vector<PathPlace> found;
      for (const PathParameter& one : asked) {
        const OffsetPlace there = offset_place(curve_, one.at, step_);
        found.push_back({there.moved, there.slope});
      }
      return found;
    };
    for (BezierCurve& piece : to_bezier(cubics_along(path, {from, to}, step_.tolerance))) {
      made_.push_back(std::move(piece));
    }
  }

  const BezierCurve& curve_;
  const SideStep& step_;
  std::vector<BezierCurve> made_;
};

}  // namespace

OffsetPlace offset_place(const BezierCurve& curve, double t, const SideStep& step) {
  const auto [point, first, second] = derivatives_at(curve, t);
  const double speed = glm::length(first);
  if (const auto way = way_from_still_end(curve, t, speed, glm::length(second))) {
    return {point, *way, point + step.distance * glm::cross(step.normal, *way), first, 1.0};
  }
  const glm::dvec3 tangent = first / speed;
  const double curvature = glm::dot(glm::cross(first, second), step.normal) / (speed * speed * speed);
  const double stretch = 1.0 - step.distance * curvature;
  return {point, tangent, point + step.distance * glm::cross(step.normal, tangent), stretch * first, stretch};
}

std::vector<BezierCurve> offset_piece(const BezierCurve& curve, const SideStep& step) {
  if (const auto line = moved_line(curve, step)) return {*line};
  if (const auto arc = scaled_arc(curve, step)) return *arc;
  return PieceOffset(curve, step).made();
}

}  // namespace splinecore
