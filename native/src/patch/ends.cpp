#include "splinecore/patch/ends.hpp"

#include <cmath>

#include "base/given_points.hpp"
#include "base/require.hpp"
#include "base/rounding.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "tolerance.hpp"
#include "without_copies.hpp"

namespace splinecore {

NurbsPatch with_domain(const NurbsPatch& patch, Axis axis, Interval domain) {
  const KnotVector& knots = patch.knot_vector(axis);
  const NurbsCurve line = NurbsCurve::make(knots, std::vector(knots.count(), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
  const std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  return with_axis(patch, axis, with_domain(line, domain).knot_vector(), points);
}

NurbsPatch clamped(const NurbsPatch& patch, Axis axis) {
  const Interval domain = patch.knot_vector(axis).domain();
  if (patch.knot_vector(axis).periodic()) return opened(patch, axis, domain.start);
  const NurbsPatch whole = cut(cut(patch, axis, domain.start), axis, domain.end);
  const NurbsPatch after = selected(whole, axis, part_after(whole.knot_vector(axis), domain.start));
  return selected(after, axis, part_before(after.knot_vector(axis), domain.end));
}

NurbsPatch unclamped(const NurbsPatch& patch, Axis axis) {
  const NurbsPatch found = along(patch, axis, [](const NurbsCurve& line) { return unclamped(line); });
  if (patch.rational() && !patch.knot_vector(axis).periodic()) {
    require_same(clamped(patch, axis).homogeneous_points(), clamped(found, axis).homogeneous_points());
  }
  return found;
}

namespace {

void require_equal_weights(const glm::dvec4& first, const glm::dvec4& last) {
  if (std::abs(first.w - last.w) <= kRoundingOfShape * std::abs(first.w)) return;
  throw InvalidShape("weights at the ends are " + text_of(first.w) + " and " + text_of(last.w) +
                     ": a periodic patch needs equal ones");
}

/// A clamped patch whose ends meet; points that lie apart go to their middle.
NurbsPatch closed_up(const NurbsPatch& patch, Axis axis) {
  const Lines lines = lines_of(patch, axis);
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  for (std::size_t i = 0; i < lines.count; ++i) {
    glm::dvec4& first = points[lines.at(i, 0)];
    const glm::dvec4& last = points[lines.at(i, lines.size - 1)];
    require_equal_weights(first, last);
    if (first != last) first = 0.5 * first + 0.5 * last;
  }
  return selected(patch.with_points(std::move(points)), axis, closed_up(patch.knot_vector(axis)));
}

bool do_ends_meet(const NurbsPatch& patch, Axis axis) {
  const Lines lines = lines_of(patch, axis);
  for (std::size_t i = 0; i < lines.count; ++i) {
    if (patch.points()[lines.at(i, 0)] != patch.points()[lines.at(i, lines.size - 1)]) return false;
  }
  return true;
}

}  // namespace

Approximation<NurbsPatch> made_periodic(const NurbsPatch& patch, Axis axis, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  if (patch.knot_vector(axis).periodic()) return {patch, 0.0};
  const double slack = tolerance.value_or(kRoundingOfShape * largest_coordinate(patch.points()));
  const NurbsPatch plain = clamped(patch, axis);
  Approximation<NurbsPatch> best{closed_up(plain, axis), 0.0};
  if (!do_ends_meet(plain, axis)) best = within(slack, patch, std::move(best.value), "the ends do not meet");
  const double seam = plain.knot_vector(axis).domain().start;
  return without_copies(std::move(best), axis, seam, patch, slack);
}

}  // namespace splinecore
