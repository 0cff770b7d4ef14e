#include "splinecore/curve/compatible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

/// The curve with its knots moved onto those of the other that are the same but for rounding.
NurbsCurve with_common_knots(const NurbsCurve& curve, const KnotVector& others) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const Interval domain = others.domain();
  const double slack = kRounding * std::max(std::abs(domain.start), std::abs(domain.end));
  std::vector<double> knots(curve.knot_vector().knots().begin(), curve.knot_vector().knots().end());
  const auto wanted = others.knots();
  for (double& knot : knots) {
    const double given = knot;
    for (auto other = std::ranges::lower_bound(wanted, given - slack); other != wanted.end(); ++other) {
      if (*other > given + slack) break;
      knot = *other;
    }
  }
  return NurbsCurve::make(KnotVector::make(curve.degree(), std::move(knots), curve.periodic()),
                          {curve.points().begin(), curve.points().end()});
}

/// The curve with the knots that only the other has. Of a period the end is the start, which is counted there.
NurbsCurve with_knots_of(const NurbsCurve& curve, const KnotVector& others) {
  const std::size_t left_out = curve.periodic() ? 1 : 0;
  const auto own = curve.knot_vector().knots();
  const auto wanted = others.knots();
  std::vector<double> missing;
  std::ranges::set_difference(wanted.first(wanted.size() - left_out), own.first(own.size() - left_out),
                              std::back_inserter(missing));
  if (missing.empty()) return curve;
  const NurbsCurve refined = refine(curve, missing);
  return curve.periodic() ? with_whole_seam(refined) : refined;
}

}  // namespace

std::pair<NurbsCurve, NurbsCurve> compatible(const NurbsCurve& a, const NurbsCurve& b) {
  const int degree = std::max(a.degree(), b.degree());
  NurbsCurve first = elevated(a, degree - a.degree());
  NurbsCurve second = elevated(b, degree - b.degree());
  if (!(first.domain() == second.domain())) second = with_domain(second, first.domain());
  if (first.knot_vector() == second.knot_vector()) return {first, second};
  const bool is_periodic = a.periodic() && b.periodic();
  first = is_periodic ? with_whole_seam(first) : clamped(first);
  second = is_periodic ? with_whole_seam(second) : clamped(second);
  second = with_common_knots(second, first.knot_vector());
  first = with_knots_of(first, second.knot_vector());
  return {first, with_knots_of(second, first.knot_vector())};
}

}  // namespace splinecore
