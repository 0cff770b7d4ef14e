#include "splinecore/curve/ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/given_points.hpp"
#include "base/length.hpp"
#include "base/rounding.hpp"
#include "basis/periodic_knots.hpp"
#include "basis/selection.hpp"
#include "rescale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/distance.hpp"
#include "without_knot.hpp"

namespace splinecore {

NurbsCurve with_domain(const NurbsCurve& curve, Interval domain) {
  const auto refused = [&](const char* why) {
    return InvalidShape("the domain from " + text_of(domain.start) + " to " + text_of(domain.end) + why);
  };
  if (!(domain.start < domain.end)) throw refused(" is empty");
  if (!std::isfinite(domain.length())) throw refused(" is not finite");
  const Interval old = curve.domain();
  std::vector<double> knots(curve.knot_vector().knots().begin(), curve.knot_vector().knots().end());
  const double scale = domain.length() / old.length();
  for (double& knot : knots) {
    // Relative to the nearer end, so that both ends are met.
    const bool is_late = knot - old.start > old.end - knot;
    knot = is_late ? domain.end + (knot - old.end) * scale : domain.start + (knot - old.start) * scale;
    if (!std::isfinite(knot)) throw refused(" takes knots out of the range of numbers");
  }
  // Rounding may bring two neighbors in the middle out of order by an ulp.
  std::inclusive_scan(knots.begin(), knots.end(), knots.begin(), [](double a, double b) { return std::max(a, b); });
  const auto given = curve.knot_vector().knots();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (given[i - 1] < given[i] && !(knots[i - 1] < knots[i])) {
      throw refused(" is so narrow that knots would become equal");
    }
  }
  return NurbsCurve::make(KnotVector::make(curve.degree(), std::move(knots), curve.periodic()),
                          {curve.points().begin(), curve.points().end()});
}

namespace {

/// Where the knots and points of a clamped curve begin and end within those of a finer one.
NurbsCurve part_of(const NurbsCurve& fine, Interval domain) {
  const auto knots = fine.knot_vector().knots();
  const int degree = fine.degree();
  const std::ptrdiff_t begin = std::ranges::upper_bound(knots, domain.start) - knots.begin() - degree - 1;
  const std::ptrdiff_t end = std::ranges::lower_bound(knots, domain.end) - knots.begin() + degree + 1;
  return NurbsCurve::make(KnotVector::make(degree, {knots.begin() + begin, knots.begin() + end}),
                          {fine.points().begin() + begin, fine.points().begin() + end - degree - 1});
}

}  // namespace

NurbsCurve clamped(const NurbsCurve& curve) {
  if (curve.periodic()) return opened(curve, curve.domain().start);
  const Interval domain = curve.domain();
  std::vector<double> missing;
  for (const double end : {domain.start, domain.end}) {
    missing.insert(missing.end(), curve.degree() + 1 - multiplicity(curve.knot_vector(), end), end);
  }
  return part_of(missing.empty() ? curve : refine(curve, missing), domain);
}

namespace {

/// How far apart the outer knots go. As wide as the span, the points would lie up to 10^7 times their old
/// distance away at degree 9, and their rounding with them; so it is 200 times at most.
double outer_step(int degree, double span) {
  constexpr double kFull = 3.0;
  return degree <= kFull ? span : span * (kFull / degree) * (kFull / degree);
}

/// Spreads the first knots, and moves the points so that the curve stays.
void unclamp_start(int p, double step, std::vector<double>& u, std::vector<glm::dvec4>& points) {
  for (int i = p - 1; i >= 0; --i) u[i] = u[i + 1] - step;
  for (int i = 0; i <= p - 2; ++i) {
    for (int j = i; j >= 0; --j) {
      const int k = p - 1 - (i - j);
      const double share = (u[p] - u[k]) / (u[p + j + 1] - u[k]);
      points[j] = (points[j] - share * points[j + 1]) / (1.0 - share);
    }
  }
}

/// The same at the end.
void unclamp_end(int p, double step, std::vector<double>& u, std::vector<glm::dvec4>& points) {
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 1; i <= p; ++i) u[last + 1 + i] = u[last + i] + step;
  for (int i = 0; i <= p - 2; ++i) {
    for (int j = i; j >= 0; --j) {
      const double share = (u[last + 1] - u[last - j]) / (u[last - j + i + 2] - u[last - j]);
      points[last - j] = (points[last - j] - (1.0 - share) * points[last - j - 1]) / share;
    }
  }
}

}  // namespace

NurbsCurve unclamped(const NurbsCurve& curve) {
  if (curve.periodic()) return unrolled(curve);
  const NurbsCurve whole = clamped(curve);
  const KnotVector& old = whole.knot_vector();
  const int p = whole.degree();
  std::vector<double> knots(old.knots().begin(), old.knots().end());
  std::vector<glm::dvec4> points = homogeneous(whole.points(), whole.weight_exponent());
  const int last = static_cast<int>(old.spans().size()) - 1;
  unclamp_start(p, outer_step(p, old.span_interval(0).length()), knots, points);
  unclamp_end(p, outer_step(p, old.span_interval(last).length()), knots, points);
  GivenPoints given = as_given_from(whole, points);
  for (int i = p - 1; i <= static_cast<int>(points.size()) - p; ++i) given.made[i] = given.old[i];
  const NurbsCurve found = NurbsCurve::make(KnotVector::make(p, std::move(knots)), std::move(given.made));
  if (whole.rational()) {
    const Scales scales = scales_of(found);
    require_same(divided(whole, scales).homogeneous_points(), clamped(divided(found, scales)).homogeneous_points());
  }
  return found;
}

namespace {

/// How far a clamped curve's end lies from its start. @throws InvalidShape if it is no end in sight.
double gap_of(const NurbsCurve& curve) {
  const glm::dvec4& first = curve.points().front();
  const glm::dvec4& last = curve.points().back();
  if (first.w == 0.0 || last.w == 0.0) throw InvalidShape("an end of the curve lies at infinity");
  if (std::abs(first.w - last.w) > kRoundingOfShape * std::abs(first.w)) {
    throw InvalidShape("the weights at the ends are " + text_of(first.w) + " and " + text_of(last.w) +
                       ": a periodic curve needs equal ones, as in standard form");
  }
  return distance_of(glm::dvec3(first), glm::dvec3(last));
}

/// A clamped curve whose ends meet as a periodic one with a seam of `degree` equal knots.
NurbsCurve closed_up(const NurbsCurve& curve) {
  Selection selection = closed_up(curve.knot_vector());
  std::vector<glm::dvec4> points;
  for (const int i : selection.indices) points.push_back(curve.points()[i]);
  const glm::dvec4& last = curve.points().back();
  glm::dvec4& seam = points[(curve.degree() - 1) % points.size()];
  if (seam != last) seam = 0.5 * seam + 0.5 * last;
  return NurbsCurve::make(std::move(selection.knots), std::move(points));
}

}  // namespace

Approximation<NurbsCurve> made_periodic(const NurbsCurve& curve, std::optional<double> tolerance) {
  if (curve.periodic()) return {curve, 0.0};
  const double slack = tolerance.value_or(kRoundingOfShape * largest_coordinate(curve.points()));
  const NurbsCurve plain = clamped(curve);
  const double gap = gap_of(plain);
  if (!(gap <= slack)) throw ToleranceNotReached("the ends do not meet", slack, gap);
  Approximation<NurbsCurve> best{closed_up(plain), 0.0};
  if (gap > 0.0) best.error = largest_distance(curve, best.value);
  if (best.error > slack) throw ToleranceNotReached("the ends do not meet", slack, best.error);
  const double seam = plain.domain().start;
  return without_copies(std::move(best), seam, curve, slack);
}

namespace {

/// A periodic curve that begins `steps` knots later.
NurbsCurve begun_at(const NurbsCurve& curve, std::ptrdiff_t steps) {
  const auto given = curve.knot_vector().knots();
  const std::ptrdiff_t count = curve.knot_vector().count();
  std::vector<double> knots;
  std::vector<glm::dvec4> points;
  for (std::ptrdiff_t i = 0; i <= count; ++i) knots.push_back(periodic_knot(given, i + steps));
  for (std::ptrdiff_t i = 0; i < count; ++i) points.push_back(curve.points()[((i + steps) % count + count) % count]);
  return NurbsCurve::make(KnotVector::make(curve.degree(), std::move(knots), true), std::move(points));
}

}  // namespace

NurbsCurve with_whole_seam(const NurbsCurve& curve) {
  const auto given = curve.knot_vector().knots();
  const std::ptrdiff_t late = std::ranges::count(given, given.back()) - 1;
  return !curve.periodic() || late == 0 ? curve : begun_at(curve, -late);
}

NurbsCurve with_seam_at(const NurbsCurve& curve, double u) {
  if (!curve.periodic()) throw InvalidShape("only a periodic curve has a seam");
  const double start = curve.knot_vector().admit(u, Side::right);
  const NurbsCurve cut = multiplicity(curve.knot_vector(), start) > 0 ? curve : insert_knot(curve, start);
  const NurbsCurve whole = with_whole_seam(cut);
  return begun_at(whole, std::ranges::lower_bound(whole.knot_vector().knots(), start) - whole.knot_vector().knots().begin());
}

}  // namespace splinecore
