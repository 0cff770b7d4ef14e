#include "patch_part.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "hull_extent.hpp"

namespace splinecore {

namespace {

using HullPoints = std::span<const glm::dvec3>;

/// Directions of the derivative of a rational piece: X' - S w' with S in a ball about `center`.
VectorCone cone_along(const BernsteinNet<glm::dvec4>& net, Axis axis, const glm::dvec3& center, double radius) {
  const std::size_t step = axis == Axis::u ? net.columns : 1;
  const std::size_t rows = axis == Axis::u ? net.rows - 1 : net.rows;
  const std::size_t columns = axis == Axis::v ? net.columns - 1 : net.columns;
  const double sign = net.values.front().w < 0.0 ? -1.0 : 1.0;
  const auto way_at = [&](std::size_t i, std::size_t j) {
    const std::size_t k = i * net.columns + j;
    const glm::dvec4 way = sign * (net.values[k + step] - net.values[k]);
    return glm::dvec4(glm::dvec3(way) - way.w * center, radius * std::abs(way.w));  // and how far the ball makes it wrong
  };
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) sum += glm::dvec3(way_at(i, j));
  }
  const double length = glm::length(sum);
  if (!(length > 0.0)) return {glm::dvec3(0.0)};
  const glm::dvec3 along = sum / length;
  double sine = 0.0;
  double wrong = 0.0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const glm::dvec4 way = way_at(i, j);
      const double own = glm::length(glm::dvec3(way));
      if (own == 0.0 && way.w == 0.0) continue;
      if (own <= way.w || glm::dot(glm::dvec3(way), along) <= 0.0) return {along};
      sine = std::max(sine, glm::length(glm::cross(glm::dvec3(way), along)) / own);
      wrong = std::max(wrong, way.w / own);
    }
  }
  return {along, std::asin(std::min(sine, 1.0)) + std::asin(wrong)};
}

/// The longest polygon of the net along an axis.
double size_along(const BernsteinNet<glm::dvec4>& net, HullPoints points, Axis axis) {
  const std::size_t lines = axis == Axis::u ? net.columns : net.rows;
  const std::size_t count = net.count(axis);
  double most = 0.0;
  for (std::size_t line = 0; line < lines; ++line) {
    double length = 0.0;
    for (std::size_t i = 1; i < count; ++i) {
      const auto at = [&](std::size_t k) { return axis == Axis::u ? k * net.columns + line : line * net.columns + k; };
      length += glm::distance(points[at(i)], points[at(i - 1)]);
    }
    most = std::max(most, length);
  }
  return most;
}

/// A vector made a unit one; zero is told apart by nothing.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : v;
}

constexpr double kSpreadMargin = 1.25;

/// Whether a part that runs through infinity is outside of a slab about another one.
bool is_outside(const PatchPart& unbounded, const PatchPart& other, double distance) {
  const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  return std::ranges::any_of(axes, [&](const glm::dvec3& axis) {
    const Interval extent = extent_along(other.points, axis, glm::dvec3(0.0));
    return is_outside_slab(unbounded.net.values, axis, {extent.start - distance, extent.end + distance});
  });
}

}  // namespace

PatchPart::PatchPart(std::size_t of_piece, const std::array<Interval, 2>& of_range, BernsteinNet<glm::dvec4> given)
    : piece(of_piece), range(of_range), net(std::move(given)), is_boxed(has_one_sign(net.values, &glm::dvec4::w)),
      size{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()} {
  if (!is_boxed) return;
  points.reserve(net.values.size());
  for (const glm::dvec4& h : net.values) points.push_back(project(h));
  size = {size_along(net, points, Axis::u), size_along(net, points, Axis::v)};
}

VectorCone PatchPart::tangent_cone(Axis axis) const {
  if (!is_boxed) return {};
  const std::size_t last_row = points.size() - net.columns;
  const glm::dvec3 center = 0.25 * (points.front() + points[net.columns - 1] + points[last_row] + points.back());
  double square = 0.0;
  for (const glm::dvec3& p : points) square = std::max(square, glm::dot(p - center, p - center));
  return cone_along(net, axis, center, std::sqrt(square));
}

/// Tangents along u within `a`, along v within `b` of two unit vectors whose cross product is as long as the sine of their
/// angle: the normal is that, and what their deviations add.
VectorCone PatchPart::normal_cone() const {
  if (!is_boxed) return {};
  const VectorCone& u = tangents(Axis::u);
  const VectorCone& v = tangents(Axis::v);
  const glm::dvec3 cross = glm::cross(u.along, v.along);
  const double sine = glm::length(cross);
  if (!(sine > 0.0)) return {};
  const double off = (u.spread + v.spread + u.spread * v.spread) / sine;
  return {cross / sine, off < 1.0 ? std::asin(off) : std::numbers::pi};
}

std::pair<PatchPart, PatchPart> PatchPart::halves() const {
  const bool is_u = is_boxed ? size[0] >= size[1] : range[0].length() >= range[1].length();
  return halves(is_u ? Axis::u : Axis::v);
}

std::pair<PatchPart, PatchPart> PatchPart::halves(Axis axis) const {
  const bool is_u = axis == Axis::u;
  BernsteinNet<glm::dvec4> first = net;
  BernsteinNet<glm::dvec4> second;
  first.halve(axis, second);
  std::array<Interval, 2> before = range;
  std::array<Interval, 2> behind = range;
  Interval& cut = before[is_u ? 0 : 1];
  behind[is_u ? 0 : 1].start = cut.middle();
  cut.end = cut.middle();
  return {PatchPart(piece, before, std::move(first)), PatchPart(piece, behind, std::move(second))};
}

PatchPart PatchPart::within(Axis axis, const Interval& kept) const {
  const std::size_t k = axis == Axis::u ? 0 : 1;
  const Interval& own = range[k];
  BernsteinNet<glm::dvec4> part = net;
  BernsteinNet<glm::dvec4> other;
  if (kept.end < own.end) part.cut(axis, (kept.end - own.start) / own.length(), other);
  if (kept.start > own.start) {
    part.cut(axis, (kept.start - own.start) / (kept.end - own.start), other);
    std::swap(part, other);
  }
  std::array<Interval, 2> of_part = range;
  of_part[k] = kept;
  return PatchPart(piece, of_part, std::move(part));
}

PatchPart part_of(std::size_t piece, const BernsteinNet<glm::dvec4>& net, const std::array<Interval, 2>& range) {
  return PatchPart(piece, {}, net).within(Axis::u, range[0]).within(Axis::v, range[1]);
}

bool are_apart(const PatchPart& a, const PatchPart& b, double distance) {
  if (a.is_boxed != b.is_boxed) return is_outside(a.is_boxed ? b : a, a.is_boxed ? a : b, distance);
  if (!a.is_boxed) return false;
  if (are_boxes_apart(a.points, b.points, distance)) return true;
  const glm::dvec3& of_a = a.normals().along;
  const glm::dvec3& of_b = b.normals().along;
  const glm::dvec3 along = unit_or_zero(glm::cross(of_a, of_b));
  const std::array<glm::dvec3, 5> axes{of_a, of_b, along, unit_or_zero(glm::cross(of_a, along)), unit_or_zero(glm::cross(of_b, along))};
  return are_apart_along(a.points, b.points, axes, distance);
}

bool are_edges_apart(const PatchPart& a, const PatchPart& b, double distance) {
  if (!a.is_boxed || !b.is_boxed) return false;
  std::array<glm::dvec3, 4> axes;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3& of_a = a.tangents(i < 2 ? Axis::u : Axis::v).along;
    const glm::dvec3& of_b = b.tangents(i % 2 == 0 ? Axis::u : Axis::v).along;
    axes[i] = unit_or_zero(glm::cross(of_a, of_b));
  }
  return are_apart_along(a.points, b.points, axes, distance);
}

bool are_apart(const CurvePart& a, const PatchPart& b, double distance) {
  if (!a.is_boxed || !b.is_boxed) return false;
  if (are_boxes_apart(a.points, b.points, distance)) return true;
  const glm::dvec3& normal = b.normals().along;
  const glm::dvec3 beside = unit_or_zero(glm::cross(a.along, normal));
  const std::array<glm::dvec3, 4> axes{normal, beside, unit_or_zero(glm::cross(a.along, beside)),
                                       unit_or_zero(glm::cross(normal, beside))};
  return are_apart_along(a.points, b.points, axes, distance);
}

bool do_normals_differ(const PatchPart& a, const PatchPart& b, double rounding) {
  if (!a.is_boxed || !b.is_boxed) return false;
  const VectorCone& of_a = a.normals();
  const VectorCone& of_b = b.normals();
  // The narrower a part is the more rounding of places turns its normals.
  static constexpr double kThinnest = 0x1p-20;
  const auto width = [](const PatchPart& part) { return std::max(kThinnest, std::min(part.size[0], part.size[1])); };
  const double rounded = rounding / width(a) + rounding / width(b);
  const double spread = kSpreadMargin * (of_a.spread + of_b.spread) + rounded;
  if (!(spread < 0.5 * std::numbers::pi)) return false;
  return std::atan2(glm::length(glm::cross(of_a.along, of_b.along)), std::abs(glm::dot(of_a.along, of_b.along))) > spread;
}

bool goes_through(const CurvePart& a, const PatchPart& b) {
  if (!a.is_boxed || !b.is_boxed) return false;
  const VectorCone& normals = b.normals();
  const double spread = kSpreadMargin * (a.spread + normals.spread);
  if (!(spread < 0.5 * std::numbers::pi)) return false;
  return std::atan2(std::abs(glm::dot(a.along, normals.along)), glm::length(glm::cross(a.along, normals.along))) > spread;
}

}  // namespace splinecore
