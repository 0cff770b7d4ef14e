#include "splinecore/curve/compatible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "near_knot.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/degree.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

/// A knot of several curves, as often as the one that has it most often.
struct CommonKnot {
  double at;
  int times;
};

/// Each knot once: where it is, and how often.
std::vector<CommonKnot> distinct(std::span<const double> knots) {
  std::vector<CommonKnot> found;
  for (const double knot : knots) {
    if (found.empty() || found.back().at != knot) found.push_back({knot, 0});
    ++found.back().times;
  }
  return found;
}

/// The nearest of common knots within a distance, or none.
const CommonKnot* nearest(const std::vector<CommonKnot>& common, double at, double slack) {
  const auto next = std::ranges::lower_bound(common, at, {}, &CommonKnot::at);
  const CommonKnot* best = nullptr;
  for (auto one = next == common.begin() ? next : next - 1; one != common.end() && one <= next; ++one) {
    const bool is_nearer = std::abs(one->at - at) <= slack && (!best || std::abs(one->at - at) < std::abs(best->at - at));
    if (is_nearer) best = &*one;
  }
  return best;
}

/// How often a place is among the last of places, which no earlier one may be further behind than a reach.
std::ptrdiff_t times_at_end(const std::vector<double>& places, double at, double reach) {
  auto first = places.end();
  while (first != places.begin() && *(first - 1) >= at - reach) --first;
  return std::count(first, places.end(), at);
}

/// The knots moved onto common ones; those that would become a gap, or be one with the end of the domain, stay.
std::vector<double> moved(const KnotVector& knots, const std::vector<CommonKnot>& common, double slack) {
  std::vector<double> places;
  const Interval domain = knots.domain();
  for (const CommonKnot& own : distinct(knots.knots())) {
    const CommonKnot* const other = nearest(common, own.at, slack);
    double at = other ? other->at : own.at;
    const auto before = times_at_end(places, at, 2.0 * slack);
    const bool is_end = at == domain.start || at == domain.end;
    if (before > 0 && (is_end || before + own.times > knots.degree())) at = own.at;
    places.insert(places.end(), own.times, at);
  }
  std::ranges::sort(places);
  return places;
}

NurbsCurve on_common_places(const NurbsCurve& curve, const std::vector<CommonKnot>& common, double slack) {
  std::vector<double> knots = moved(curve.knot_vector(), common, slack);
  if (std::ranges::equal(knots, curve.knot_vector().knots())) return curve;
  return NurbsCurve::make(KnotVector::make(curve.degree(), std::move(knots), curve.periodic()),
                          {curve.points().begin(), curve.points().end()});
}

void add(std::vector<CommonKnot>& common, const KnotVector& knots) {
  std::vector<CommonKnot> all;
  std::ranges::merge(common, distinct(knots.knots()), std::back_inserter(all), {}, &CommonKnot::at, &CommonKnot::at);
  common.clear();
  for (const CommonKnot& knot : all) {
    if (!common.empty() && common.back().at == knot.at) {
      common.back().times = std::max(common.back().times, knot.times);
    } else {
      common.push_back(knot);
    }
  }
}

/// The curve with the knots that only others have. Of a period the end is the start, which is counted there.
NurbsCurve with_all(const NurbsCurve& curve, const std::vector<CommonKnot>& common) {
  std::vector<double> all;
  for (const CommonKnot& knot : common) all.insert(all.end(), knot.times, knot.at);
  const std::size_t left_out = curve.periodic() ? 1 : 0;
  const auto own = curve.knot_vector().knots();
  std::vector<double> missing;
  std::ranges::set_difference(std::span(all).first(all.size() - left_out), own.first(own.size() - left_out),
                              std::back_inserter(missing));
  if (missing.empty()) return curve;
  const NurbsCurve refined = refine(curve, missing);
  return curve.periodic() ? with_whole_seam(refined) : refined;
}

bool have_one_knot_vector(std::span<const NurbsCurve> curves) {
  return std::ranges::all_of(curves, [&](const NurbsCurve& curve) { return curve.knot_vector() == curves[0].knot_vector(); });
}

}  // namespace

std::vector<NurbsCurve> compatible(std::span<const NurbsCurve> curves, double knot_distance) {
  if (curves.empty()) throw InvalidShape("there is no curve");
  if (!(knot_distance >= 0.0 && knot_distance < 1.0)) {
    throw InvalidShape("knot_distance = " + text_of(knot_distance) + ": a part of the domain from 0 to below 1 is expected");
  }
  const int degree = std::ranges::max_element(curves, {}, &NurbsCurve::degree)->degree();
  const Interval domain = curves[0].domain();
  std::vector<NurbsCurve> made;
  for (const NurbsCurve& curve : curves) {
    made.push_back(elevated(curve, degree - curve.degree()));
    if (!(made.back().domain() == domain)) made.back() = with_domain(made.back(), domain);
  }
  if (have_one_knot_vector(made)) return made;
  const bool is_periodic = std::ranges::all_of(curves, &NurbsCurve::periodic);
  double share = knot_distance;
  for (const NurbsCurve& curve : curves) share = std::max(share, knot_rounding(curve.domain()));
  const double slack = share * domain.length();
  std::vector<CommonKnot> common;
  for (NurbsCurve& curve : made) {
    curve = is_periodic ? with_whole_seam(curve) : clamped(curve);
    curve = on_common_places(curve, common, slack);
    add(common, curve.knot_vector());
  }
  for (NurbsCurve& curve : made) curve = with_all(curve, common);
  return made;
}

std::pair<NurbsCurve, NurbsCurve> compatible(const NurbsCurve& a, const NurbsCurve& b) {
  const std::array<NurbsCurve, 2> both{a, b};
  const std::vector<NurbsCurve> made = compatible(both);
  return {made[0], made[1]};
}

}  // namespace splinecore
