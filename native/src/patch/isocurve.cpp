#include "splinecore/patch/isocurve.hpp"

#include <algorithm>

#include "base/given_points.hpp"
#include "basis/point_matrix.hpp"
#include "lines.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// The homogeneous point that a stencil makes of a line.
glm::dvec4 point_of(const Stencil& stencil, std::span<const glm::dvec4> net, const Lines& lines, std::size_t line) {
  const auto weights = stencil.weights(0);
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * net[lines.at(line, stencil.first() + i)];
  }
  return sum;
}

}  // namespace

NurbsCurve isocurve(const NurbsPatch& patch, Axis axis, double at, Side side) {
  const KnotVector& knots = patch.knot_vector(axis);
  Stencil stencil(knots, 0);
  stencil.move_to(knots.admit(at, side), side);
  const Lines lines = lines_of(patch, axis);
  const Lines wide = homogeneous_lines_of(patch, axis);
  std::vector<glm::dvec4> points;
  for (std::size_t line = 0; line < lines.count; ++line) {
    points.push_back(point_of(stencil, patch.homogeneous_points(), wide, line));
  }
  GivenPoints given = as_given_from(patch, points);
  if (const int copied = copied_point(stencil.weights(0)); copied >= 0) {
    const std::size_t place = (stencil.first() + copied) % lines.size;
    for (std::size_t line = 0; line < lines.count; ++line) given.made[line] = given.old[lines.at(line, place)];
  }
  return NurbsCurve::make(patch.knot_vector(across(axis)), std::move(given.made));
}

BezierCurve isocurve(const BezierPatch& patch, Axis axis, double at) {
  return as_bezier(isocurve(patch.nurbs(), axis, at));
}

NurbsCurve boundary(const NurbsPatch& patch, Border border) {
  const Axis axis = axis_of(border);
  const Interval domain = patch.knot_vector(axis).domain();
  return is_at_end(border) ? isocurve(patch, axis, domain.end, Side::left)
                           : isocurve(patch, axis, domain.start, Side::right);
}

BezierCurve boundary(const BezierPatch& patch, Border border) { return as_bezier(boundary(patch.nurbs(), border)); }

}  // namespace splinecore
