#include "base/sort_by.hpp"
#include "common_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"

namespace splinecore {

namespace {

/// A knot by how far along the domain it lies, in the direction of a.
struct SharedKnot {
  double share;
  double knot;
  int copies;
};

/// The knots inside the domain, and of a period its start.
std::vector<SharedKnot> knots_along(const KnotVector& knots, bool is_reversed) {
  const Interval domain = knots.domain();
  std::vector<SharedKnot> found;
  const auto all = knots.knots();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_start = all[i] == domain.start;
    if (all[i] < domain.start || all[i] >= domain.end || (is_start && !knots.periodic())) continue;
    if (!found.empty() && found.back().knot == all[i]) {
      ++found.back().copies;
      continue;
    }
    const double share =
        is_reversed && !is_start ? (domain.end - all[i]) / domain.length() : (all[i] - domain.start) / domain.length();
    found.push_back({share, all[i], 1});
  }
  sort_by(found, [](const SharedKnot& knot) { return knot.share; });
  return found;
}

double knot_at(double share, Interval domain, bool is_reversed) {
  if (share == 0.0) return domain.start;
  const bool is_late = (share > 0.5) != is_reversed;
  const double from_end = is_late == is_reversed ? share : 1.0 - share;
  return is_late ? domain.end - from_end * domain.length() : domain.start + from_end * domain.length();
}

/// What rounding makes of a share.
double slack_of(Interval domain) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  return kRounding * (1.0 + std::max(std::abs(domain.start), std::abs(domain.end)) / domain.length());
}

InvalidShape not_apart() {
  return InvalidShape("knots of one patch lie so near to one another along the edge that the other cannot tell them "
                      "apart");
}

/// The knots that the patch on `domain` lacks of those of `others`.
std::vector<double> missing_knots(const std::vector<SharedKnot>& own, const std::vector<SharedKnot>& others,
                                  Interval domain, bool is_reversed, double slack) {
  std::vector<double> missing;
  auto next = own.begin();
  for (const SharedKnot& other : others) {
    while (next != own.end() && next->share < other.share - slack) ++next;
    const bool is_own = next != own.end() && next->share <= other.share + slack;
    const double knot = is_own ? next->knot : knot_at(other.share, domain, is_reversed);
    const bool is_inside = knot > domain.start && knot < domain.end;
    const bool is_apart = is_inside && !std::ranges::count(own, knot, &SharedKnot::knot) &&
                          !std::ranges::count(missing, knot);
    if (!is_own && !is_apart) throw not_apart();
    missing.insert(missing.end(), std::max(0, other.copies - (is_own ? next->copies : 0)), knot);
    if (is_own) ++next;
  }
  std::ranges::sort(missing);
  return missing;
}

NurbsPatch with_whole_seam(const NurbsPatch& patch, Axis axis) {
  if (!patch.knot_vector(axis).periodic()) return patch;
  return along(patch, axis, [](const NurbsCurve& line) { return splinecore::with_whole_seam(line); });
}

NurbsPatch refined(const NurbsPatch& patch, Axis axis, const std::vector<double>& missing) {
  return missing.empty() ? patch : with_whole_seam(refine(patch, axis, missing), axis);
}

/// Point i along a has the knots i - degree + 1 … i as polar values; reversed, they begin with the last.
std::vector<std::size_t> columns_against(const KnotVector& knots) {
  const std::ptrdiff_t count = knots.count();
  const std::ptrdiff_t turn = knots.periodic() ? knots.degree() + multiplicity(knots, knots.domain().start) - 2 : -1;
  std::vector<std::size_t> columns(count);
  for (std::ptrdiff_t i = 0; i < count; ++i) columns[i] = (2 * count - i + turn) % count;
  return columns;
}

}  // namespace

CommonEdge on_common_edge(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b, bool is_reversed) {
  const Axis on_a = across(axis_of(side_a));
  const Axis on_b = across(axis_of(side_b));
  const bool is_periodic = a.knot_vector(on_a).periodic() && b.knot_vector(on_b).periodic();
  const int degree = std::max(a.knot_vector(on_a).degree(), b.knot_vector(on_b).degree());
  const auto prepared = [&](const NurbsPatch& patch, Axis axis) {
    const NurbsPatch ended = clamped(patch, across(axis));
    const NurbsPatch whole = is_periodic ? ended : clamped(ended, axis);
    return with_whole_seam(elevated(whole, axis, degree - patch.knot_vector(axis).degree()), axis);
  };
  NurbsPatch first = prepared(a, on_a);
  NurbsPatch second = prepared(b, on_b);
  const auto knots_a = knots_along(first.knot_vector(on_a), false);
  const auto knots_b = knots_along(second.knot_vector(on_b), is_reversed);
  const Interval domain_a = first.knot_vector(on_a).domain();
  const Interval domain_b = second.knot_vector(on_b).domain();
  const double slack = slack_of(domain_a) + slack_of(domain_b);
  first = refined(first, on_a, missing_knots(knots_a, knots_b, domain_a, false, slack));
  second = refined(second, on_b, missing_knots(knots_b, knots_a, domain_b, is_reversed, slack));
  if (first.count(on_a) != second.count(on_b)) throw not_apart();
  std::vector<std::size_t> columns(first.count(on_a));
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  if (is_reversed) columns = columns_against(second.knot_vector(on_b));
  return {std::move(first), std::move(second), std::move(columns)};
}

}  // namespace splinecore
