#include "splinecore/curve/removal.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "splinecore/base/as_many.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/least_squares.hpp"
#include "splinecore/basis/refinement.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

KnotVector without(const KnotVector& knots, double u, int times) {
  std::vector<double> kept(knots.knots().begin(), knots.knots().end());
  const auto at = std::ranges::find(kept, u);
  kept.erase(at, at + times);
  return KnotVector::make(knots.degree(), std::move(kept), knots.periodic());
}

/// How many copies of u may go: those inside the domain, and of a periodic seam all but one.
int removable(const NurbsCurve& curve, double u) {
  const Interval domain = curve.domain();
  const int copies = multiplicity(curve.knot_vector(), u);
  if (domain.start < u && u < domain.end) return copies;
  return curve.periodic() && u == domain.start ? copies - 1 : 0;
}

/// A point before the removal that one point afterwards is a copy of.
struct Kept {
  std::vector<int> fixed;             ///< points afterwards
  std::vector<glm::dvec4> start;      ///< all points afterwards, the kept ones in their places
};

/// Points are kept where they alone set a point before; where two of a gap meet neither is.
Kept kept_points(const PointMatrix& matrix, const std::vector<glm::dvec4>& points) {
  Kept kept;
  const int count = matrix.from().count();
  for (int i = 0; i < count; ++i) kept.start.push_back(points[std::min<std::size_t>(i, points.size() - 1)]);
  // The points afterwards numbered by themselves tell which row copies which.
  std::vector<glm::dvec4> numbers;
  for (int i = 0; i < count; ++i) numbers.emplace_back(i, 0.0, 0.0, 1.0);
  std::vector<glm::dvec4> copied(points.size(), glm::dvec4(-1.0));
  matrix.keep_untouched(numbers.data(), 1, copied.data(), 1);
  std::vector<int> sources(count, -1);
  std::vector<bool> is_torn(count, false);
  for (std::size_t j = 0; j < copied.size(); ++j) {
    const int i = static_cast<int>(copied[j].x);
    if (i < 0) continue;
    if (sources[i] >= 0 && points[sources[i]] != points[j]) is_torn[i] = true;
    sources[i] = static_cast<int>(j);
  }
  for (int i = 0; i < count; ++i) {
    if (sources[i] < 0) continue;
    kept.start[i] = points[sources[i]];
    if (!is_torn[i]) kept.fixed.push_back(i);
  }
  return kept;
}

NurbsCurve removed(const NurbsCurve& curve, double u, int times) {
  const KnotVector target = without(curve.knot_vector(), u, times);
  const PointMatrix matrix = refinement(target, std::vector<double>(times, u));
  const std::vector<glm::dvec4> points = homogeneous(curve.points());
  Kept kept = kept_points(matrix, points);
  const Kept given = kept_points(matrix, {curve.points().begin(), curve.points().end()});
  const std::vector<glm::dvec4> nearest = closest_preimage(matrix, points, std::move(kept.start), kept.fixed);
  std::vector<glm::dvec4> found = as_given_from(curve, nearest);
  for (const int i : kept.fixed) found[i] = given.start[i];
  return NurbsCurve::make(target, std::move(found));
}

}  // namespace

NurbsCurve without_knot(const NurbsCurve& curve, double u, int times) {
  const NurbsCurve whole = curve.periodic() ? with_whole_seam(curve) : curve;
  const double at = whole.knot_vector().admit(u, Side::right);
  const int most = removable(whole, at);
  if (times < 1 || times > most) {
    if (most < 1) throw InvalidShape("u = " + text_of(u) + " is no knot that can be removed");
    throw InvalidShape("times = " + std::to_string(times) + " is outside [1, " + std::to_string(most) + "]");
  }
  return removed(whole, at, times);
}

Approximation<NurbsCurve> remove_knot(const NurbsCurve& curve, double u, int times, std::optional<double> tolerance) {
  NurbsCurve result = without_knot(curve, u, times);
  const double error = largest_distance(curve, result);
  if (tolerance && error > *tolerance) throw ToleranceNotReached("the knot cannot be removed", *tolerance, error);
  return {std::move(result), error};
}

Approximation<NurbsCurve> without_copies(Approximation<NurbsCurve> best, double u, const NurbsCurve& original,
                                         double tolerance) {
  const auto without = [&](const NurbsCurve& curve, int times) -> std::optional<Approximation<NurbsCurve>> {
    try {
      const NurbsCurve whole = curve.periodic() ? with_whole_seam(curve) : curve;
      if (removable(whole, u) < times) return std::nullopt;
      Approximation<NurbsCurve> found{removed(whole, u, times), 0.0};
      found.error = largest_distance(original, found.value);
      if (found.error <= tolerance) return found;
    } catch (const InvalidShape&) {
      // A weight that falls to nearly zero throws its point out of the range of numbers.
    }
    return std::nullopt;
  };
  return removed_as_often_as_can_be(std::move(best), without);
}

Approximation<NurbsCurve> remove_knots(const NurbsCurve& curve, double tolerance) {
  if (!(tolerance >= 0.0)) throw InvalidShape("tolerance = " + text_of(tolerance) + " is below 0");
  Approximation<NurbsCurve> best{curve.periodic() ? with_whole_seam(curve) : curve, 0.0};
  std::vector<double> distinct(best.value.knot_vector().knots().begin(), best.value.knot_vector().knots().end());
  distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
  for (const double u : distinct) best = without_copies(std::move(best), u, curve, tolerance);
  return best;
}

}  // namespace splinecore
