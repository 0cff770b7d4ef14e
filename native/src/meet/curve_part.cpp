#include "curve_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>

#include "base/one_sign.hpp"
#include "base/quotient.hpp"
#include "curve_pieces.hpp"
#include "hull_extent.hpp"

namespace splinecore {

namespace {

/// The angle between two vectors, the first of length 1, without loss where it is small (Kahan).
double angle_between(const glm::dvec3& unit, const glm::dvec3& other, double length) {
  return 2.0 * std::atan2(glm::length(other - length * unit), glm::length(other + length * unit));
}

/// Of a polygon's legs with a vector of length 1: tangents of half angles tell which is the largest one.
double largest_angle(const glm::dvec3& unit, std::span<const glm::dvec3> points) {
  double off = 0.0;
  double on = 1.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec3 leg = points[i] - points[i - 1];
    const double length = glm::length(leg);
    if (!(length > 0.0)) continue;
    const glm::dvec3 less = leg / length - unit;
    const glm::dvec3 more = leg / length + unit;
    const double off_here = glm::dot(less, less);
    const double on_here = glm::dot(more, more);
    if (!(off_here * on > off * on_here)) continue;
    off = off_here;
    on = on_here;
  }
  return 2.0 * std::atan2(std::sqrt(off), std::sqrt(on));
}

glm::dvec3 across(const glm::dvec3& unit) {
  const glm::dvec3 steps = glm::abs(unit);
  const glm::dvec3 axis = steps.x <= steps.y && steps.x <= steps.z ? glm::dvec3(1, 0, 0)
                          : steps.y <= steps.z                     ? glm::dvec3(0, 1, 0)
                                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(unit, axis));
}

/// A right angle, less what angles are rounded by.
constexpr double kBelowRight = 0.5 * std::numbers::pi - 0x1p-20;

constexpr std::array<glm::dvec3, 3> kAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};

/// Whether a part that runs through infinity is apart from one with a box.
bool is_outside(const CurvePart& part, const CurvePart& boxed, double distance) {
  const glm::dvec3 beside = across(boxed.along);
  const std::array<glm::dvec3, 3> own{boxed.along, beside, glm::cross(boxed.along, beside)};
  const auto is_apart = [&](const glm::dvec3& axis) {
    const Interval slab = extent_along(boxed.points, axis, glm::dvec3(0.0));
    return is_outside_slab(part.net.values, axis, {slab.start - distance, slab.end + distance});
  };
  return std::ranges::any_of(kAxes, is_apart) || std::ranges::any_of(own, is_apart);
}

}  // namespace

/// Tangents of a rational piece with weights of one sign are in the cone of its polygon's legs: each step of de
/// Casteljau's algorithm makes legs that are sums of multiples above zero of those before.
CurvePart::CurvePart(std::size_t of_piece, const Interval& of_range, BernsteinNet<glm::dvec4> given,
                     BernsteinNet<glm::dvec4> given_sums)
    : piece(of_piece), range(of_range), net(std::move(given)), sums(std::move(given_sums)),
      is_boxed(has_one_sign(net.values, &glm::dvec4::w)), spread(std::numbers::pi),
      size(std::numeric_limits<double>::infinity()) {
  if (!is_boxed) return;
  points.reserve(net.rows);
  for (const glm::dvec4& h : net.values) points.push_back(project(h));
  size = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) size += glm::distance(points[i], points[i - 1]);
  const glm::dvec3 chord = points.back() - points.front();
  const double length = glm::length(chord);
  if (length > 0.0) along = chord / length;
  for (std::size_t i = 0; i < sums.rows; ++i) {
    rounding = std::max(rounding, rounding_across(net.values[i], sums.values[i], along));
  }
  if (!(length > 0.0)) return;
  spread = largest_angle(along, points);
}

std::pair<CurvePart, CurvePart> CurvePart::halves() const {
  BernsteinNet<glm::dvec4> first = net;
  BernsteinNet<glm::dvec4> second;
  first.halve(Axis::u, second);
  BernsteinNet<glm::dvec4> first_sums = sums;
  BernsteinNet<glm::dvec4> second_sums;
  if (!sums.values.empty()) first_sums.halve(Axis::u, second_sums);
  const double middle = range.middle();
  return {CurvePart(piece, {range.start, middle}, std::move(first), std::move(first_sums)),
          CurvePart(piece, {middle, range.end}, std::move(second), std::move(second_sums))};
}

bool are_apart(const CurvePart& a, const CurvePart& b, double distance) {
  if (!a.is_boxed && !b.is_boxed) return false;
  if (!a.is_boxed) return is_outside(a, b, distance);
  if (!b.is_boxed) return is_outside(b, a, distance);
  if (are_boxes_apart(a.points, b.points, distance)) return true;
  // What lies beside each other along a slope is told apart by axes along and across it.
  const glm::dvec3 offset = b.points.front() - a.points.front();
  return std::ranges::any_of(std::array{&a, &b}, [&](const CurvePart* part) {
    const glm::dvec3 beside = offset - glm::dot(offset, part->along) * part->along;
    const double length = glm::length(beside);
    const glm::dvec3 one = length > 0.0 ? beside / length : across(part->along);
    const std::array<glm::dvec3, 3> axes{part->along, one, glm::cross(part->along, one)};
    return are_apart_along(a.points, b.points, axes, distance);
  });
}

bool are_apart_along(const CurvePart& a, const CurvePart& b, const glm::dvec3& axis, double distance) {
  return are_apart_along(a.points, b.points, std::array{axis}, distance);
}

bool is_off(const glm::dvec3& point, const CurvePart& part, double distance) {
  const glm::dvec3 offset = point - part.points.front();
  const glm::dvec3 beside = offset - glm::dot(offset, part.along) * part.along;
  const double length = glm::length(beside);
  return length > distance && extent_along(part.points, beside / length, point).end < -distance;
}

bool is_far_out(const CurvePart& part) {
  constexpr double kFar = 0x1p20;
  if (part.sums.values.empty()) return false;
  const auto is_outside_along = [&](const glm::dvec3& axis) {
    return is_outside_slab(part.net.values, axis, {-kFar, kFar});
  };
  return std::ranges::any_of(kAxes, is_outside_along);
}

bool do_tangents_differ(const CurvePart& a, const CurvePart& b, double distance) {
  if (!a.is_boxed || !b.is_boxed) return false;
  constexpr double kMargin = 1.25;
  const double between = angle_between(a.along, b.along, 1.0);
  const double angle = std::min(between, std::numbers::pi - between);
  return angle > kMargin * (a.spread + b.spread) && angle * std::min(a.size, b.size) > distance;
}

bool is_monotone(const CurvePart& part) { return part.is_boxed && part.spread < kBelowRight; }

bool are_monotone(const CurvePart& a, const CurvePart& b) {
  if (!a.is_boxed || !b.is_boxed) return false;
  const double between = angle_between(a.along, b.along, 1.0);
  return 0.5 * between + std::max(a.spread, b.spread) < kBelowRight;
}

}  // namespace splinecore
