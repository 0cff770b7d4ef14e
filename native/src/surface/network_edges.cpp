#include "network_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/quotient.hpp"
#include "curve/near_knot.hpp"
#include "patch/lines.hpp"
#include "span_places.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// The sides along a family, the first curve first.
std::array<Border, 2> borders_along(bool is_u) {
  return is_u ? std::array{Border::v_start, Border::v_end} : std::array{Border::u_start, Border::u_end};
}

/// A curve on the knots of a side, which has all of its own.
std::vector<glm::dvec4> on_knots_of(const NurbsCurve& side, const NurbsCurve& curve) {
  const NurbsCurve found = curve.knot_vector() == side.knot_vector() ? curve : compatible(side, curve).second;
  return {found.points().begin(), found.points().end()};
}

void write(std::vector<glm::dvec4>& net, const NurbsPatch& patch, Border border, const NurbsCurve& curve) {
  const std::vector<glm::dvec4> row = on_knots_of(boundary(patch, border), curve);
  const auto count_u = static_cast<std::size_t>(patch.count(Axis::u));
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  if (row.size() != (axis_of(border) == Axis::u ? count_v : count_u)) return;  // knots that only rounding tells apart: as it is
  const std::size_t step = axis_of(border) == Axis::u ? 1 : count_v;
  const std::size_t first = !is_at_end(border) ? 0 : axis_of(border) == Axis::u ? (count_u - 1) * count_v : count_v - 1;
  for (std::size_t i = 0; i < row.size(); ++i) net[first + i * step] = row[i];
}

std::vector<double> distances_at(const NurbsCurve& side, const NurbsCurve& curve, const std::vector<double>& places) {
  breathe(places.size());
  std::vector<glm::dvec3> on_side(places.size());
  std::vector<glm::dvec3> on_curve(places.size());
  const EvaluateOptions options{.side = Side::left, .at_infinity = AtInfinity::nan};
  evaluate(side, places, {&on_side.front().x, 3 * places.size()}, options);
  evaluate(curve, places, {&on_curve.front().x, 3 * places.size()}, options);
  std::vector<double> found;
  for (std::size_t k = 0; k < places.size(); ++k) {
    found.push_back(is_finite(on_side[k]) && is_finite(on_curve[k]) ? distance_of(on_side[k], on_curve[k]) : 0.0);
  }
  return found;
}

/// The largest distance of a side from a curve over its domain, looked for closer about where it is.
double largest_distance(const NurbsCurve& side, const NurbsCurve& curve) {
  constexpr int kInSpan = 16;
  constexpr int kParts = 24;
  const Interval domain = side.domain();
  std::vector<double> ends{domain.start, domain.end};
  for (const NurbsCurve* const one : {&side, &curve}) {
    for (const double knot : one->knot_vector().knots()) {
      if (knot > domain.start && knot < domain.end) ends.push_back(knot);
    }
  }
  const std::vector<double> places = places_of_spans(std::move(ends), kInSpan);
  const std::vector<double> found = distances_at(side, curve, places);
  const auto at = static_cast<std::size_t>(std::ranges::max_element(found) - found.begin());
  const double from = places[at > 0 ? at - 1 : 0];
  const double to = places[std::min(at + 1, places.size() - 1)];
  std::vector<double> closer;
  for (int k = 1; k < kParts; ++k) closer.push_back(from + (to - from) * k / kParts);
  return std::max(found[at], std::ranges::max(distances_at(side, curve, closer)));
}

/// The known interval where the other one differs from it by rounding alone.
Interval unless_rounding(Interval known, Interval found) {
  const double slack = knot_rounding(known) * known.length();
  const bool is_one = std::abs(found.start - known.start) <= slack && std::abs(found.end - known.end) <= slack;
  return is_one ? known : found;
}

NurbsPatch begun_at(const NurbsPatch& patch, Axis axis, const NetworkFamily& family, const NetworkFamily& others) {
  if (!family.is_closed || others.is_closed) return patch;
  const std::size_t kept = family.order.front() < family.order.back() ? 0 : family.curves.size() - 1;
  const double seam = family.seams[kept].at;
  const Interval domain = patch.knot_vector(axis).domain();
  if (seam == domain.start || seam == domain.end) return patch;
  const NurbsPatch turned = along(patch, axis, [&](const NurbsCurve& line) { return with_seam_at(line, seam); });
  const double start = seam >= domain.end ? seam : seam - domain.length();
  return with_domain(turned, axis, unless_rounding(family.seams[kept].domain, {start, start + domain.length()}));
}

}  // namespace

NurbsPatch with_outermost(const NurbsPatch& patch, const PacedFamily& u, const PacedFamily& v) {
  std::vector<glm::dvec4> net(patch.points().begin(), patch.points().end());
  for (const bool is_u : {false, true}) {
    const PacedFamily& family = is_u ? u : v;
    if ((is_u ? v : u).is_closed) continue;
    write(net, patch, borders_along(is_u)[0], family.curves.front());
    write(net, patch, borders_along(is_u)[1], family.curves.back());
  }
  return patch.with_points(std::move(net));
}

std::array<std::optional<double>, 4> distances_of_paces(const NurbsPatch& patch, const PacedFamily& u, const PacedFamily& v) {
  std::array<std::optional<double>, 4> found;
  for (const bool is_u : {false, true}) {
    const PacedFamily& family = is_u ? u : v;
    if ((is_u ? v : u).is_closed) continue;
    const std::array<Border, 2> borders = borders_along(is_u);
    for (std::size_t i = 0; i < 2; ++i) {
      const NurbsCurve& given = i == 0 ? family.own.front() : family.own.back();
      found[(is_u ? 2 : 0) + i] = largest_distance(boundary(patch, borders[i]), given);
    }
  }
  return found;
}

NurbsPatch begun_as_given(const NurbsPatch& patch, const NetworkCurves& curves) {
  return begun_at(begun_at(patch, Axis::u, curves.u, curves.v), Axis::v, curves.v, curves.u);
}

}  // namespace splinecore
