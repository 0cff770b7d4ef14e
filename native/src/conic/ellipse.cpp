#include "splinecore/conic/ellipse.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "base/require.hpp"
#include "numbers.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/plane.hpp"

namespace splinecore {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Cosine of 15 degrees times `steps`, to the last digit.
double cosine_of_steps(int steps) {
  static const std::array<double, 7> kFirstQuarter{
      1.0, (std::sqrt(6.0) + std::sqrt(2.0)) / 4.0, std::sqrt(0.75), std::sqrt(0.5), 0.5,
      (std::sqrt(6.0) - std::sqrt(2.0)) / 4.0, 0.0};
  const int around = ((steps % 24) + 24) % 24;
  const int half = around <= 12 ? around : 24 - around;
  return half <= 6 ? kFirstQuarter[half] : -kFirstQuarter[12 - half];
}

struct CosineAndSine {
  double cosine;
  double sine;
};

CosineAndSine direction_of(double angle) {
  constexpr double kStep = std::numbers::pi / 12.0;
  const double steps = std::round(angle / kStep);
  if (std::abs(angle - steps * kStep) > 4.0 * kEpsilon * std::abs(angle)) return {std::cos(angle), std::sin(angle)};
  const int whole = static_cast<int>(std::fmod(steps, 24.0));
  return {cosine_of_steps(whole), cosine_of_steps(whole - 6)};
}

struct Axes {
  glm::dvec3 center;
  glm::dvec3 a;
  glm::dvec3 b;

  glm::dvec3 offset(const CosineAndSine& d) const { return d.cosine * a + d.sine * b; }
};

Axes admitted(const glm::dvec3& center, const glm::dvec3& a, const glm::dvec3& b) {
  require_vector(center, "center");
  require_vector(a, "axis_a");
  require_vector(b, "axis_b");
  const double length_a = length_of(a);
  const double length_b = length_of(b);
  if (!std::isnormal(length_a)) throw InvalidShape("axis_a has the length " + text_of(length_a));
  if (!std::isnormal(length_b)) throw InvalidShape("axis_b has the length " + text_of(length_b));
  if (length_of(accurate_cross(a / length_a, b / length_b)) > 4.0 * kEpsilon) return {center, a, b};
  throw InvalidShape("axis_b is parallel to axis_a: they span no ellipse");
}

bool is_whole_turn(double sweep) { return std::abs(std::abs(sweep) - kTurn) <= 4.0 * kEpsilon * kTurn; }

int require_spans(double start, double sweep, int span_count) {
  constexpr int kMostSpans = 1 << 16;
  if (!std::isfinite(start)) throw InvalidShape("start = " + text_of(start) + " is not finite");
  if (!std::isfinite(sweep) || sweep == 0.0 || (std::abs(sweep) > kTurn && !is_whole_turn(sweep))) {
    throw InvalidShape("sweep = " + text_of(sweep) + " is zero or more than a whole turn");
  }
  if (span_count < 0 || span_count > kMostSpans) {
    throw InvalidShape("span_count = " + std::to_string(span_count) + " is outside [0, " +
                       std::to_string(kMostSpans) + "]");
  }
  if (span_count == 1 && is_whole_turn(sweep)) throw InvalidShape("span_count = 1: one span cannot hold a whole turn");
  const double quarters = std::abs(sweep) / (kTurn / 4.0);
  return span_count > 0 ? span_count : std::max(1, static_cast<int>(std::ceil(quarters * (1.0 - 4.0 * kEpsilon))));
}

NurbsCurve arc(const Axes& axes, double start, double sweep, int spans) {
  const double weight = direction_of(sweep / (2.0 * spans)).cosine;
  const auto at = [&](int half_spans) { return direction_of(start + sweep * half_spans / (2.0 * spans)); };
  std::vector<glm::dvec4> points{{axes.center + axes.offset(at(0)), 1.0}};
  std::vector<double> knots{0.0, 0.0, 0.0};
  for (int i = 1; i <= spans; ++i) {
    const glm::dvec3 middle = axes.offset(at(2 * i - 1));
    points.push_back(weight == 0.0 ? glm::dvec4(middle, 0.0) : glm::dvec4(axes.center + middle / weight, weight));
    points.emplace_back(axes.center + axes.offset(at(2 * i)), 1.0);
    knots.insert(knots.end(), 2, i);
  }
  knots.push_back(spans);
  if (is_whole_turn(sweep)) points.back() = points.front();
  return NurbsCurve::make(2, std::move(knots), std::move(points));
}

NurbsCurve single_span(const Axes& axes) {
  constexpr std::array<CosineAndSine, 6> kPoints{{{1, 0}, {1, 4}, {-3, 2}, {-3, -2}, {1, -4}, {1, 0}}};
  constexpr std::array<double, 6> kWeights{5, 1, 1, 1, 1, 5};
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < 6; ++i) points.emplace_back(axes.center + axes.offset(kPoints[i]), kWeights[i]);
  return NurbsCurve::make(KnotVector::bezier(5), std::move(points));
}

}  // namespace

NurbsCurve ellipse(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b, EllipseForm form) {
  const Axes axes = admitted(center, axis_a, axis_b);
  switch (form) {
    case EllipseForm::triangle: return arc(axes, 0.0, kTurn, 3);
    case EllipseForm::halves: return arc(axes, 0.0, kTurn, 2);
    case EllipseForm::single: return single_span(axes);
    case EllipseForm::square: break;
  }
  return arc(axes, 0.0, kTurn, 4);
}

NurbsCurve circle(const glm::dvec3& center, double radius, const glm::dvec3& normal, EllipseForm form) {
  require_positive(radius, "radius");
  require_vector(center, "center");
  const Plane plane = plane_across(center, normal);
  return ellipse(center, radius * plane.x_axis, radius * plane.y_axis, form);
}

NurbsCurve ellipse_arc(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b, double start,
                       double sweep, int span_count) {
  const Axes axes = admitted(center, axis_a, axis_b);
  return arc(axes, start, sweep, require_spans(start, sweep, span_count));
}

std::vector<NurbsCurve> hyperbola(const glm::dvec3& center, const glm::dvec3& axis_a, const glm::dvec3& axis_b) {
  const Axes axes = admitted(center, axis_a, axis_b);
  const auto branch = [&](double sign) {
    const glm::dvec3 from = sign * (axes.a - axes.b);
    const glm::dvec3 to = sign * (axes.a + axes.b);
    return NurbsCurve::make(KnotVector::make(2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}),
                            {{2.0 * from, 0.0}, {center + from, 1.0}, {center + sign * axes.a, 1.0}, {center + to, 1.0},
                             {2.0 * to, 0.0}});
  };
  return {branch(1.0), branch(-1.0)};
}

}  // namespace splinecore
