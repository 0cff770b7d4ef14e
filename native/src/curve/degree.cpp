#include "splinecore/curve/degree.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/given_points.hpp"
#include "basis/elevation.hpp"
#include "basis/least_squares.hpp"
#include "basis/refinement.hpp"
#include "made_of.hpp"
#include "of_lower_degree.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

NurbsCurve elevated(const NurbsCurve& curve, int times) {
  if (times < 0) throw InvalidShape("times = " + std::to_string(times) + " is below 0");
  if (times > kMaxDegree - curve.degree()) {
    throw InvalidShape("times = " + std::to_string(times) + ": the degree would exceed " + std::to_string(kMaxDegree));
  }
  if (times == 0) return curve;
  if (!curve.periodic()) {
    auto [knots, points, copied] = elevated(curve.knot_vector(), curve.homogeneous_points(), times);
    return made_of(curve, std::move(knots), std::move(points), copied);
  }
  NurbsCurve raised = curve;
  for (int i = 0; i < times; ++i) raised = applied(elevation(raised.knot_vector()), raised);
  return raised;
}

namespace {

/// Knots of one degree less with one copy fewer of each knot, but one at least; those of a periodic
/// vector begin with all copies of the first.
KnotVector lowered(const KnotVector& knots) {
  const auto given = knots.knots();
  std::vector<double> kept;
  for (auto begin = given.begin(); begin != given.end();) {
    const auto end = std::upper_bound(begin, given.end(), *begin);
    const std::ptrdiff_t copies = end - begin;
    kept.insert(kept.end(), std::max<std::ptrdiff_t>(copies - 1, 1), *begin);
    begin = end;
  }
  return KnotVector::make(knots.degree() - 1, std::move(kept), knots.periodic());
}

/// The knots that are in `wanted` and not in `knots`.
std::vector<double> missing(const KnotVector& knots, const KnotVector& wanted) {
  std::vector<double> found;
  std::ranges::set_difference(wanted.knots(), knots.knots(), std::back_inserter(found));
  return found;
}

/// A first guess: the Greville-like neighbor, every point from a point beside it.
std::vector<glm::dvec4> first_guess(std::span<const glm::dvec4> points, int count) {
  std::vector<glm::dvec4> guess;
  const double step = count > 1 ? static_cast<double>(points.size() - 1) / (count - 1) : 0.0;
  for (int i = 0; i < count; ++i) guess.push_back(points[static_cast<std::size_t>(i * step + 0.5)]);
  return guess;
}

NurbsCurve reduced_once(const NurbsCurve& curve) {
  const KnotVector target = lowered(curve.knot_vector());
  const PointMatrix matrix = elevation(target);
  const std::vector<double> inserted = missing(curve.knot_vector(), matrix.knots());
  const NurbsCurve fine = inserted.empty() ? curve : refine(curve, inserted);
  const auto points = fine.homogeneous_points().first(fine.points().size());
  std::vector<glm::dvec4> start = first_guess(points, target.count());
  std::vector<int> fixed;
  if (!curve.periodic()) {
    fixed = {0, target.count() - 1};
    start.front() = points.front();
    start.back() = points.back();
  }
  auto [found, old, divided] = as_given_from(fine, closest_preimage(matrix, points, std::move(start), fixed));
  if (!curve.periodic()) {
    found.front() = old.front();
    found.back() = old.back();
  }
  return NurbsCurve::make(target, std::move(found));
}

}  // namespace

NurbsCurve of_lower_degree(const NurbsCurve& curve, int times) {
  if (times < 1 || times >= curve.degree()) {
    throw InvalidShape("times = " + std::to_string(times) + " is outside [1, " + std::to_string(curve.degree() - 1) +
                       "]: a curve needs degree 1 or more");
  }
  NurbsCurve lower = curve.periodic() ? with_whole_seam(curve) : clamped(curve);
  for (int i = 0; i < times; ++i) lower = reduced_once(lower);
  return lower;
}

Approximation<NurbsCurve> reduced(const NurbsCurve& curve, int times, std::optional<double> tolerance) {
  NurbsCurve lower = of_lower_degree(curve, times);
  const double error = largest_distance(curve, lower);
  if (tolerance && error > *tolerance) throw ToleranceNotReached("the degree cannot be lowered", *tolerance, error);
  return {std::move(lower), error};
}

}  // namespace splinecore
