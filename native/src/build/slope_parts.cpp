#include "slope_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <utility>

#include "measure/numerators.hpp"
#include "offset_box.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

std::vector<double> bends_of(std::span<const glm::dvec4> points, const glm::dvec3& normal) {
  const PlaneView view(normal);
  std::vector<glm::dvec3> seen;
  for (const glm::dvec4& p : points) seen.emplace_back(view.seen(glm::dvec3(p)), p.w);
  return bend_of(seen).coefficients;
}

SlopePart whole(const BezierCurve& curve, const std::optional<glm::dvec3>& normal) {
  const auto points = curve.nurbs().homogeneous_points();
  std::vector<double> weights;
  for (const glm::dvec4& p : points) weights.push_back(p.w);
  std::vector<glm::dvec3> slopes;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<glm::dvec2> line;
    for (const glm::dvec4& p : points) line.emplace_back(p[axis], p.w);
    const Numerator slope = slope_of(line);
    slopes.resize(slope.coefficients.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i][axis] = slope.coefficients[i];
  }
  return {{0.0, 1.0}, BernsteinNet<glm::dvec3>::of_curve(std::move(slopes)), BernsteinNet<double>::of_curve(std::move(weights)),
          BernsteinNet<double>::of_curve(normal ? bends_of(points, *normal) : std::vector{0.0})};
}

std::pair<SlopePart, SlopePart> halves(SlopePart first) {
  SlopePart second;
  first.slope.halve(Axis::u, second.slope);
  first.weight.halve(Axis::u, second.weight);
  first.bend.halve(Axis::u, second.bend);
  const double middle = first.part.middle();
  second.part = {middle, first.part.end};
  first.part.end = middle;
  return {std::move(first), std::move(second)};
}

}  // namespace

Interval SlopePart::slope_lengths() const {
  glm::dvec3 sum(0.0);
  double most = 0.0;
  for (const glm::dvec3& p : slope.values) {
    sum += p;
    most = std::max(most, glm::length(p));
  }
  const double length = glm::length(sum);
  if (!(length > 0.0)) return {0.0, most};
  double least = most;
  for (const glm::dvec3& p : slope.values) least = std::min(least, glm::dot(p, sum) / length);
  return {std::max(0.0, least), most};
}

std::vector<Interval> parts_that_matter(const BezierCurve& curve, const std::optional<glm::dvec3>& normal, int depth,
                                        const std::function<bool(const SlopePart&)>& matters) {
  const double least = 1.0 / static_cast<double>(1 << depth);
  std::vector<SlopePart> open{whole(curve, normal)};
  std::vector<Interval> found;
  while (!open.empty()) {
    breathe(16 * open.back().slope.values.size());
    SlopePart part = std::move(open.back());
    open.pop_back();
    if (!matters(part)) continue;
    if (part.part.length() <= least) {
      found.push_back(part.part);
      continue;
    }
    auto [first, second] = halves(std::move(part));
    open.push_back(std::move(second));
    open.push_back(std::move(first));
  }
  return found;
}

}  // namespace splinecore
