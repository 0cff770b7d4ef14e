#include "ribbon.hpp"

#include <algorithm>
#include <cmath>

#include "patch/lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

/// The part of the patch between the side and the first knot across.
NurbsPatch strip_of(const NurbsPatch& patch, Border side) {
  const Axis axis = axis_of(side);
  const KnotVector& knots = patch.knot_vector(axis);
  const int last = static_cast<int>(knots.spans().size()) - 1;
  if (last == 0) return clamped(patch, axis);
  if (is_at_end(side)) return clamped(split(patch, axis, knots.span_interval(last).start).second, axis);
  return clamped(split(patch, axis, knots.span_interval(0).end).first, axis);
}

}  // namespace

Ribbon ribbon_of(const NurbsPatch& patch, Border side) {
  const Axis axis = axis_of(side);
  if (patch.knot_vector(axis).periodic()) {
    throw InvalidShape("the side of a neighbor is the seam of a periodic direction: it is not an edge");
  }
  const NurbsPatch strip = strip_of(patch, side);
  const Lines lines = lines_of(strip, axis);
  Ribbon ribbon{{}, strip.knot_vector(axis).domain().length()};
  for (std::size_t row = 0; row < lines.size; ++row) {
    std::vector<glm::dvec4> points;
    for (std::size_t i = 0; i < lines.count; ++i) {
      points.push_back(strip.points()[lines.at(i, is_at_end(side) ? lines.size - 1 - row : row)]);
    }
    ribbon.rows.push_back(NurbsCurve::make(strip.knot_vector(across(axis)), std::move(points)));
  }
  return ribbon;
}

std::vector<glm::dvec4> derivative_out(const Ribbon& ribbon, int order) {
  const int degree = static_cast<int>(ribbon.rows.size()) - 1;
  std::vector<glm::dvec4> found(ribbon.rows[0].points().size(), glm::dvec4(0.0));
  if (order > degree) return found;
  std::vector<std::vector<glm::dvec4>> rows;
  for (int k = 0; k <= order; ++k) rows.push_back(homogeneous(ribbon.rows[k].points()));
  double factor = 1.0;
  for (int round = 0; round < order; ++round) {
    factor *= -(degree - round) / ribbon.width;
    for (int k = 0; k + round < order; ++k) {
      for (std::size_t i = 0; i < found.size(); ++i) rows[k][i] = rows[k + 1][i] - rows[k][i];
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = factor * rows[0][i];
  return found;
}

}  // namespace splinecore
