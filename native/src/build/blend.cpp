#include "splinecore/build/blend.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/length.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kHighest = 3;
using EndJet = std::array<glm::dvec3, kHighest + 1>;

/// The point and its derivatives by the parameter.
EndJet by_parameter(const BlendEnd& end) {
  const Interval domain = end.curve.domain();
  const double u = end.is_end ? domain.end : domain.start;
  EndJet d;
  derivatives(end.curve, std::span(&u, 1), kHighest, std::span(&d[0].x, 3 * d.size()),
              {.side = end.is_end ? Side::left : Side::right, .at_infinity = AtInfinity::raise, .threads = 1});
  return d;
}

/// By the length, of a curve that is `unit` times as large, of which the parameter goes from 0 to `scale`.
EndJet by_length(EndJet d, double scale, double unit) {
  double power = 1.0 / unit;
  for (int k = 1; k <= kHighest; ++k) d[static_cast<std::size_t>(k)] *= (power *= scale);
  const double v = glm::length(d[1]);
  if (!(v > 0.0) || !std::isfinite(v)) throw InvalidShape("a curve has a zero derivative at its end: it has no direction there");
  const glm::dvec3 first = d[1] / v;
  const glm::dvec3 second = d[2] / v;
  const glm::dvec3 third = d[3] / v;
  const double v1 = glm::dot(first, second);
  const double v2 = glm::dot(second, second) + glm::dot(first, third) - v1 * v1;
  return {d[0], first, (second - v1 * first) / v, (third - 3.0 * v1 * second - (v2 - 3.0 * v1 * v1) * first) / (v * v)};
}

/// The control points next to an end of a Bezier curve that has those derivatives there, the end's point first.
std::vector<glm::dvec3> points_beside(const EndJet& jet, int order, int degree) {
  // Differences of control points are derivatives over falling factorials of the degree.
  std::vector<glm::dvec3> differences{jet[0]};
  double factor = 1.0;
  for (int k = 1; k <= order; ++k) {
    factor *= degree - k + 1;
    differences.push_back(jet[static_cast<std::size_t>(k)] / factor);
  }
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= order; ++i) {
    glm::dvec3 point(0.0);
    double choose = 1.0;
    for (int k = 0; k <= i; ++k) {
      point += choose * differences[static_cast<std::size_t>(k)];
      choose = choose * (i - k) / (k + 1);
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

BezierCurve blend(const BlendEnd& from, const BlendEnd& to, int continuity, const std::array<double, 2>& strengths) {
  if (continuity < 0 || continuity > kHighest) {
    throw InvalidShape("continuity is " + std::to_string(continuity) + ", not 0, 1, 2 or 3");
  }
  for (const double strength : strengths) {
    if (!(strength > 0.0) || !std::isfinite(strength)) throw InvalidShape("a strength is not above 0");
  }
  const EndJet first = by_parameter(from);
  const EndJet last = by_parameter(to);
  const glm::dvec3 start = first[0];
  const glm::dvec3 end = last[0];
  const double unit = distance_of(start, end);
  if (!(unit > 0.0)) throw InvalidShape("the ends of the curves coincide: there is nothing between them");
  if (continuity == 0) return BezierCurve::make({glm::dvec4(start, 1.0), glm::dvec4(end, 1.0)});
  const int degree = 2 * continuity + 1;
  std::vector<glm::dvec4> points(static_cast<std::size_t>(degree) + 1);
  for (const bool is_start : {true, false}) {
    const BlendEnd& of = is_start ? from : to;
    EndJet jet = by_length(is_start ? first : last, of.curve.domain().length(), unit);
    jet[0] = glm::dvec3(0.0);
    // Seen from its end the blend runs into the curve that it follows; away from that one along its start, or its end.
    const double way = (is_start == of.is_end ? 1.0 : -1.0) * (is_start ? 1.0 : -1.0);
    double power = 1.0;
    for (std::size_t k = 1; k < jet.size(); ++k) jet[k] *= (power *= way * strengths[is_start ? 0 : 1]);
    const std::vector<glm::dvec3> beside = points_beside(jet, continuity, degree);
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const std::size_t at = is_start ? i : points.size() - 1 - i;
      points[at] = glm::dvec4((is_start ? start : end) + unit * beside[i], 1.0);
    }
  }
  return BezierCurve::make(std::move(points));
}

}  // namespace splinecore
