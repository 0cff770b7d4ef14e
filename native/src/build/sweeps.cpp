#include "splinecore/build/sweeps.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/compatible.hpp"
#include "spokes.hpp"

namespace splinecore {

namespace {

/// What is left of a point on the axis after its part along the axis has been taken away is less, as a part of the
/// curve's size, also after the curve was moved there.

/// An axis through a point, of unit length.
struct AxisLine {
  glm::dvec3 point;
  glm::dvec3 direction;

  glm::dvec3 along(const glm::dvec3& v) const { return glm::dot(v, direction) * direction; }
};

/// How far the points of a curve and the axis lie from one another and from the origin, at most.
double size_of(const NurbsCurve& curve, const AxisLine& axis) {
  double size = glm::length(axis.point);
  for (const glm::dvec4& p : curve.points()) {
    if (p.w != 0.0) size = std::max({size, glm::length(glm::dvec3(p)), glm::length(glm::dvec3(p) - axis.point)});
  }
  return size;
}

Spoke spoke_of(const glm::dvec4& p, const AxisLine& axis, double size) {
  const glm::dvec3 from_axis = p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) - axis.point;
  const glm::dvec3 once = from_axis - axis.along(from_axis);
  // Twice, because far up the axis the first step leaves a rest along it.
  const glm::dvec3 out = once - axis.along(once);
  if (p.w == 0.0) size = glm::length(from_axis);
  if (!(glm::length(out) > kRoundingOfShape * size)) return {glm::dvec3(p), glm::dvec3(0.0), glm::dvec3(0.0), p.w};
  return {glm::dvec3(p) - out, out, glm::cross(axis.direction, out), p.w};
}

NurbsPatch between_rows(const KnotVector& knots, std::span<const glm::dvec4> start, std::span<const glm::dvec4> end) {
  std::vector<glm::dvec4> net;
  net.reserve(2 * start.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    net.push_back(start[i]);
    net.push_back(end[i]);
  }
  return NurbsPatch::make(knots, KnotVector::bezier(1), std::move(net));
}

}  // namespace

NurbsPatch revolve(const NurbsCurve& curve, const glm::dvec3& axis_point, const glm::dvec3& axis_direction, Turn turn) {
  require_place(axis_point, "axis_point");
  const double length = require_length(axis_direction, "axis_direction");
  const AxisLine axis{axis_point, axis_direction / length};
  std::vector<Spoke> spokes;
  const double size = size_of(curve, axis);
  for (const glm::dvec4& p : curve.points()) spokes.push_back(spoke_of(p, axis, size));
  const bool is_flat = std::ranges::all_of(spokes, [](const Spoke& spoke) { return spoke.out == glm::dvec3(0.0); });
  if (is_flat) throw InvalidShape("the curve lies on the axis: turning it makes no surface");
  return turned(curve.knot_vector(), spokes, turn);
}

NurbsPatch extrude(const NurbsCurve& curve, const glm::dvec3& vector) {
  require_length(vector, "vector");
  std::vector<glm::dvec4> moved(curve.points().begin(), curve.points().end());
  for (glm::dvec4& p : moved) {
    if (p.w != 0.0) p += glm::dvec4(vector, 0.0);
  }
  return between_rows(curve.knot_vector(), curve.points(), moved);
}

NurbsPatch ruled(const NurbsCurve& a, const NurbsCurve& b) {
  const auto [first, second] = compatible(a, b);
  return between_rows(first.knot_vector(), first.points(), second.points());
}

}  // namespace splinecore
