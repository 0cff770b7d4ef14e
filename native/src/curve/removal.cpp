#include "splinecore/curve/removal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/as_many.hpp"
#include "base/given_points.hpp"
#include "base/require.hpp"
#include "basis/knot_removal.hpp"
#include "basis/least_squares.hpp"
#include "basis/refinement.hpp"
#include "basis/removal_rounds.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/ends.hpp"
#include "without_knot.hpp"

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
Kept kept_points(const PointMatrix& matrix, std::span<const glm::dvec4> points) {
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

/// The nearest by conjugate gradients, for any number of copies.
NurbsCurve nearest_without(const NurbsCurve& curve, double u, int times) {
  const KnotVector target = without(curve.knot_vector(), u, times);
  const PointMatrix matrix = refinement(target, std::vector<double>(times, u));
  const auto points = curve.homogeneous_points().first(curve.points().size());
  Kept kept = kept_points(matrix, points);
  const std::vector<glm::dvec4> nearest = closest_preimage(matrix, points, std::move(kept.start), kept.fixed);
  auto [found, old, divided] = as_given_from(curve, nearest);
  const Kept given = kept_points(matrix, old);
  for (const int i : kept.fixed) found[i] = given.start[i];
  return NurbsCurve::make(target, std::move(found));
}

KnotList list_of(const NurbsCurve& plain) {
  const auto points = plain.homogeneous_points();
  return {plain.knot_vector(), {points.begin(), points.end()}, 1};
}

/// A plain curve without these knots of its list, one after the other.
NurbsCurve without_listed(const NurbsCurve& plain, std::span<const int> order) {
  KnotList list = list_of(plain);
  for (const int i : order) list.remove(i);
  const KnotList::Rest rest = list.rest();
  auto [made, old, divided] = as_given_from(plain, rest.rows);
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (rest.origins[i] >= 0) made[i] = old[rest.origins[i]];
  }
  return NurbsCurve::make(rest.knots, std::move(made));
}

/// Points whose weights were divided as they were before, unless one would lose digits so.
std::vector<glm::dvec4> with_weights_back(std::vector<glm::dvec4> points, int exponent) {
  std::vector<glm::dvec4> back = with_weights_divided(points, -exponent);
  return with_weights_divided(back, exponent) == points ? back : points;
}

/// Part of a plain curve, as far as copies of a knot that go reach, in place of it.
NurbsCurve nearest_on_plain(const NurbsCurve& plain, double u, int times) {
  const auto knots = plain.knot_vector().knots();
  const int degree = plain.degree();
  const auto [low, high] = std::ranges::equal_range(knots, u);
  if (times == 1) {
    const int last = static_cast<int>(high - knots.begin()) - 1;
    return without_listed(plain, {&last, 1});
  }
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, (low - knots.begin()) - 2 * degree - 2);
  const std::ptrdiff_t end = std::min<std::ptrdiff_t>(knots.size(), (high - knots.begin()) + 2 * degree + 2);
  const std::ptrdiff_t row_end = end - degree - 1;
  const std::vector<glm::dvec4> points = with_weights_divided(plain.points(), plain.weight_exponent());
  const NurbsCurve part = NurbsCurve::make(KnotVector::make(degree, {knots.begin() + begin, knots.begin() + end}),
                                           {points.begin() + begin, points.begin() + row_end});
  const NurbsCurve shorter = nearest_without(part, u, times);
  std::vector<glm::dvec4> made(points.begin(), points.begin() + begin);
  made.insert(made.end(), shorter.points().begin(), shorter.points().end());
  made.insert(made.end(), points.begin() + row_end, points.end());
  return NurbsCurve::make(without(plain.knot_vector(), u, times),
                          with_weights_back(std::move(made), plain.weight_exponent()));
}

/// The plain curve that unrolled() made of a periodic one as that again: no point near its ends has changed.
NurbsCurve rolled_up(const NurbsCurve& plain) {
  KnotVector knots = rolled_up(plain.knot_vector());
  const auto points = plain.points().first(knots.count());
  return NurbsCurve::make(std::move(knots), {points.begin(), points.end()});
}

NurbsCurve removed(const NurbsCurve& curve, double u, int times) {
  if (!curve.periodic()) return nearest_on_plain(curve, u, times);
  if (std::ranges::binary_search(knots_at_seam(curve.knot_vector()), u)) return nearest_without(curve, u, times);
  return rolled_up(nearest_on_plain(unrolled(curve), u, times));
}

/// How far the curve around one knot of a list moves when it goes.
double true_cost(const KnotList& list, int i) {
  const KnotList::Rest part = list.around_of(i);
  try {
    const NurbsCurve before = NurbsCurve::from_homogeneous(part.knots, part.rows);
    return largest_distance(before, nearest_on_plain(before, list.knot(i), 1));
  } catch (const InvalidShape&) {
    return HUGE_VAL;  // a part at infinity
  }
}

}  // namespace

NurbsCurve without_knot(const NurbsCurve& curve, double u, int times) {
  const NurbsCurve whole = curve.periodic() ? with_whole_seam(curve) : curve;
  const double at = whole.knot_vector().admit(u, Side::right);
  const int most = removable(whole, at);
  if (times < 1 || times > most) {
    if (most < 1) throw InvalidShape("u = " + text_of(u) + " is not a knot that can be removed");
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
  require_tolerance(tolerance);
  const NurbsCurve whole = curve.periodic() ? with_whole_seam(curve) : curve;
  const auto without = [](const NurbsCurve& some, std::span<const int> order) {
    return some.periodic() ? rolled_up(without_listed(unrolled(some), order)) : without_listed(some, order);
  };
  const auto list = [](const NurbsCurve& some) { return list_of(unrolled(some)); };
  const auto distance = [&](const NurbsCurve& some) { return largest_distance(curve, some); };
  std::vector<double> kept = curve.periodic() ? knots_at_seam(whole.knot_vector()) : std::vector<double>{};
  Approximation<NurbsCurve> best =
      without_listed_knots<NurbsCurve>({whole, 0.0}, tolerance, std::move(kept), list, without, distance, &true_cost);
  if (!curve.periodic()) return best;
  const KnotVector knots = best.value.knot_vector();
  return without_knots_at_seam(std::move(best), knots, [&](Approximation<NurbsCurve> some, double u) {
    return without_copies(std::move(some), u, curve, tolerance);
  });
}

}  // namespace splinecore
