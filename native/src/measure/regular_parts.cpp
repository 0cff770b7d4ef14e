#include "regular_parts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Halvings before what is left is as short as rounding: a cusp's arms grow with the square of the parameter.
constexpr int kDepth = 28;

/// What decides on a part of a span: A' W - A W' of the homogeneous curve (A, W), in Bernstein's form.
struct Slopes {
  BernsteinNet<glm::dvec3> piece;
  double rounding = 0.0;
};

Slopes slopes_of(const std::vector<glm::dvec4>& points) {
  const int degree = static_cast<int>(points.size()) - 1;
  Slopes slopes{BernsteinNet<glm::dvec3>::of_curve(std::vector<glm::dvec3>(2 * degree, glm::dvec3(0.0))), 0.0};
  double size = 0.0;
  double weight = 0.0;
  for (const glm::dvec4& p : points) {
    size = std::max(size, glm::length(glm::dvec3(p)));
    weight = std::max(weight, std::abs(p.w));
  }
  for (int i = 0; i < degree; ++i) {
    const glm::dvec4 step = points[i + 1] - points[i];
    for (int j = 0; j <= degree; ++j) {
      const double share = binomial(degree - 1, i) * binomial(degree, j) / binomial(2 * degree - 1, i + j);
      slopes.piece.values[i + j] += share * (glm::dvec3(step) * points[j].w - step.w * glm::dvec3(points[j]));
    }
  }
  constexpr double kRounding = 0x1p-48;
  slopes.rounding = kRounding * size * weight;
  return slopes;
}

/// Whether the slopes are zero at the ends of their part at most, or are nothing but rounding.
bool is_regular(const Slopes& slopes) {
  glm::dvec3 direction(0.0);
  double largest = 0.0;
  for (const glm::dvec3& slope : slopes.piece.values) {
    direction += slope;
    largest = std::max(largest, glm::length(slope));
  }
  if (largest <= slopes.rounding) return true;
  if (glm::length(direction) <= slopes.rounding) return false;
  return std::ranges::all_of(slopes.piece.values, [&](const auto& slope) { return glm::dot(slope, direction) >= 0.0; });
}

void add_parts(Slopes slopes, const Interval& part, int depth, std::vector<Interval>& parts) {
  if (depth == 0 || is_regular(slopes)) {
    parts.push_back(part);
    return;
  }
  Slopes second{{}, slopes.rounding};
  slopes.piece.halve(Axis::u, second.piece);
  add_parts(std::move(slopes), {part.start, part.middle()}, depth - 1, parts);
  add_parts(std::move(second), {part.middle(), part.end}, depth - 1, parts);
}

}  // namespace

std::vector<Interval> regular_parts(const NurbsCurve& curve, const Interval& range) {
  std::vector<Interval> parts;
  for (std::size_t i = 0; i < curve.knot_vector().spans().size(); ++i) {
    const Interval span = curve.knot_vector().span_interval(static_cast<int>(i));
    if (span.end <= range.start || span.start >= range.end) continue;
    add_parts(slopes_of(bezier_piece(curve, static_cast<int>(i)).values), span, kDepth, parts);
  }
  std::vector<Interval> within;
  for (const Interval& part : parts) {
    const Interval common{std::max(part.start, range.start), std::min(part.end, range.end)};
    if (common.start < common.end) within.push_back(common);
  }
  return within;
}

}  // namespace splinecore
