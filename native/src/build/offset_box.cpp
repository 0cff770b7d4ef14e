#include "offset_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "base/rounding.hpp"
#include "basis/bernstein_net.hpp"
#include "curve/bezier_piece.hpp"

namespace splinecore {

namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();

glm::dvec2 left_of(const glm::dvec2& way) { return {-way.y, way.x}; }

double angle_between(const glm::dvec2& a, const glm::dvec2& b) {
  return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
}

/// What rounding may add to numbers about 1 large.

}  // namespace

PlaneView::PlaneView(const glm::dvec3& normal) {
  const glm::dvec3 across = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  x_ = glm::normalize(glm::cross(across, normal));
  y_ = glm::cross(normal, x_);
}

glm::dvec2 PlaneView::seen(const glm::dvec3& p) const { return {glm::dot(p, x_), glm::dot(p, y_)}; }

OffsetBox::OffsetBox(std::vector<glm::dvec3> points, const Interval& part, double side)
    : points_(std::move(points)), part_(part), side_(side) {
  if (points_.front().z < 0.0) {
    for (glm::dvec3& p : points_) p = -p;
  }
  is_finite_ = std::ranges::all_of(points_, [](const glm::dvec3& p) { return p.z > 0.0; });
  if (!is_finite_) return;
  std::vector<glm::dvec2> polygon;
  for (const glm::dvec3& p : points_) polygon.push_back(glm::dvec2(p) / p.z);
  find_tangents(polygon);
  middle_ = 0.5 * (polygon.front() + polygon.back()) + side_ * left_of(way_);
}

/// Derivatives are sums of steps from control point to control point with factors that are not negative: of rational curves, too,
/// whose weights are positive (Sederberg and Wang 1987).
void OffsetBox::find_tangents(const std::vector<glm::dvec2>& polygon) {
  glm::dvec2 sum(0.0);
  std::vector<glm::dvec2> steps;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const glm::dvec2 step = polygon[i + 1] - polygon[i];
    const double length = glm::length(step);
    if (!(length > 0.0)) continue;
    steps.push_back(step / length);
    sum += steps.back();
  }
  const double length = glm::length(sum);
  if (!(length > 0.0)) return;
  double low = 0.0;
  double high = 0.0;
  for (const glm::dvec2& step : steps) {
    const double angle = angle_between(sum, step);
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  constexpr double kRight = 0.5 * std::numbers::pi;
  if (!(high < kRight && low > -kRight)) return;
  const double turn = 0.5 * (low + high);
  const glm::dvec2 base = sum / length;
  way_ = std::cos(turn) * base + std::sin(turn) * left_of(base);
  half_angle_ = 0.5 * (high - low) + kRoundingOfSum;
}

double OffsetBox::size() const {
  if (!is_finite_) return kAll;
  double reach = 0.0;
  const glm::dvec2 from = glm::dvec2(points_.front()) / points_.front().z;
  for (const glm::dvec3& p : points_) reach = std::max(reach, glm::distance(glm::dvec2(p) / p.z, from));
  return reach + std::abs(side_) * std::min(half_angle_, 2.0);
}

Interval OffsetBox::along(const glm::dvec2& direction) const {
  if (!is_finite_) return {-kAll, kAll};
  Interval found{kAll, -kAll};
  for (const glm::dvec3& p : points_) {
    const double at = glm::dot(glm::dvec2(p), direction) / p.z;
    found.start = std::min(found.start, at);
    found.end = std::max(found.end, at);
  }
  const double distance = std::abs(side_);
  double most = 1.0;
  double least = -1.0;
  if (half_angle_ < kUnknown) {
    const double between = std::abs(angle_between(side_ < 0.0 ? -left_of(way_) : left_of(way_), direction));
    most = std::cos(std::max(0.0, between - half_angle_));
    least = std::cos(std::min(std::numbers::pi, between + half_angle_));
  }
  return {found.start + distance * least - kRoundingOfSum, found.end + distance * most + kRoundingOfSum};
}

std::pair<OffsetBox, OffsetBox> OffsetBox::halves() const {
  auto first = BernsteinNet<glm::dvec3>::of_curve(points_);
  BernsteinNet<glm::dvec3> second;
  first.halve(Axis::u, second);
  const double middle = part_.middle();
  return {OffsetBox(std::move(first.values), {part_.start, middle}, side_),
          OffsetBox(std::move(second.values), {middle, part_.end}, side_)};
}

std::vector<OffsetBox> offset_boxes(const NurbsCurve& curve, const PlaneView& view, double side) {
  std::vector<OffsetBox> boxes;
  for (int i = 0; i < static_cast<int>(curve.knot_vector().spans().size()); ++i) {
    std::vector<glm::dvec3> points;
    for (const glm::dvec4& p : bezier_piece(curve, i).values) points.emplace_back(view.seen(glm::dvec3(p)), p.w);
    boxes.emplace_back(std::move(points), curve.knot_vector().span_interval(i), side);
  }
  return boxes;
}

bool are_apart(const OffsetBox& a, const OffsetBox& b) {
  const glm::dvec2 gap = b.middle() - a.middle();
  const double length = glm::length(gap);
  const glm::dvec2 toward = length > 0.0 ? gap / length : glm::dvec2(1.0, 0.0);
  for (const glm::dvec2& way : {toward, left_of(a.way()), a.way(), left_of(b.way()), b.way()}) {
    const Interval of_a = a.along(way);
    const Interval of_b = b.along(way);
    if (of_a.end < of_b.start || of_b.end < of_a.start) return true;
  }
  return false;
}

bool is_beyond(const OffsetBox& box, const glm::dvec2& place, double distance) {
  const glm::dvec2 gap = place - box.middle();
  const double length = glm::length(gap);
  const glm::dvec2 toward = length > 0.0 ? gap / length : glm::dvec2(1.0, 0.0);
  for (const glm::dvec2& way : {toward, left_of(box.way()), box.way()}) {
    const Interval reach = box.along(way);
    const double at = glm::dot(place, way);
    if (at + distance < reach.start || at - distance > reach.end) return true;
  }
  return false;
}

}  // namespace splinecore
