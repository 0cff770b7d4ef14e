#include "side_curve.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "base/length.hpp"
#include "basis/bernstein_net.hpp"
#include "lines.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// How far rounding may move a knot of a side; far from zero, or on a short part of a domain, by some ulps of its ends.
double one_knot(const Interval& domain, const Interval& range) {
  constexpr double kLeast = 0x1p-40;
  constexpr double kUlps = 0x1p-50;
  return std::max(kLeast, kUlps * std::max(std::abs(domain.start), std::abs(domain.end)) / range.length());
}

/// The homogeneous points of an isocurve, those of the lines from `first` up to `end`.
std::vector<glm::dvec4> isocurve_points(const NurbsPatch& patch, Axis axis, double at, Side side, int first, int end) {
  Stencil stencil(patch.knot_vector(axis), 0);
  stencil.move_to(at, side);
  const auto weights = stencil.weights(0);
  const auto net = patch.homogeneous_points();
  const Lines lines = homogeneous_lines_of(patch, axis);
  std::vector<glm::dvec4> points;
  for (int line = first; line < end; ++line) {
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * net[lines.at(line, stencil.first() + i)];
    points.push_back(sum);
  }
  return points;
}

bool is_point(std::span<const glm::dvec4> points, double tolerance) {
  const bool has_directions = std::ranges::any_of(points, [](const glm::dvec4& p) { return p.w == 0.0; });
  return !has_directions && extent(as_given(points)) <= tolerance;
}

/// A parameter of a side on its way from 0 to 1.
struct SideWalk {
  const SideCurve& side;
  std::size_t span = 0;
  double part = 0.0;  ///< of the span

  std::size_t spans() const { return side.breaks.size() - 1; }
  double next() const { return side.breaks[span + 1]; }
  bool is_at_end() const { return span + 1 == spans() && part == 1.0; }

  /// The part of the span at a parameter before its end.
  double part_at(double t) const {
    return std::clamp((t - side.breaks[span]) / (next() - side.breaks[span]), part, 1.0);
  }
  void move_to(double to) {
    const bool is_over = to == 1.0 && span + 1 < spans();
    span += is_over ? 1 : 0;
    part = is_over ? 0.0 : to;
  }
};

/// The point at a part of a span; without numbers where that lies at infinity.
glm::dvec3 point_at(const SideCurve& side, std::size_t span, double part) {
  std::vector<double> row(side.degree + 1);
  bernstein(side.degree, part, 1.0 - part, row);
  const glm::dvec4 point = weighted_sum(row, side.pieces.data() + span * row.size());
  return glm::dvec3(point) / point.w;
}

glm::dvec3 start_of(const SideCurve& side) { return point_at(side, 0, 0.0); }
glm::dvec3 end_of(const SideCurve& side) { return point_at(side, side.breaks.size() - 2, 1.0); }

glm::dvec3 point_at(const SideCurve& side, double t) {
  const auto next = std::ranges::upper_bound(side.breaks, t);
  const std::size_t span = std::min<std::size_t>(next - side.breaks.begin(), side.breaks.size() - 1) - 1;
  return point_at(side, span, SideWalk{side, span}.part_at(t));
}

/// Along a direction in which few points have the same place.
double place_of(const glm::dvec3& point) {
  constexpr glm::dvec3 kDirection(0.71, 0.53, 0.46);
  const double at = glm::dot(kDirection, point);
  return std::isfinite(at) ? at : std::numeric_limits<double>::infinity();
}

SideCurve turned(SideCurve side) {
  std::ranges::reverse(side.pieces);
  std::ranges::reverse(side.breaks);
  for (double& t : side.breaks) t = 1.0 - t;
  return side;
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  return distance_of(a, b) <= tolerance;
}

/// Whether two sides have the very same pieces.
bool is_same(const SideCurve& a, const SideCurve& b) {
  const double scale = std::ldexp(1.0, b.weight_exponent - a.weight_exponent);
  const auto equal = [&](const glm::dvec4& p, const glm::dvec4& q) { return p == scale * q; };
  return a.degree == b.degree && a.breaks == b.breaks && std::ranges::equal(a.pieces, b.pieces, equal);
}

/// Of each break of a the one of b that is the same knot, if any. Where knots lie so near together that rounding may
/// have moved them, as many of each side are the same, one by one; otherwise those that are equal.
std::vector<std::optional<std::size_t>> partners(const std::vector<double>& a, const std::vector<double>& b,
                                                 double one_knot) {
  std::vector<std::optional<std::size_t>> found(a.size());
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < a.size() && k < b.size()) {
    std::size_t end_i = i;
    std::size_t end_k = k;
    for (double reach = std::min(a[i], b[k]) + one_knot;;) {
      if (end_i < a.size() && a[end_i] <= reach) reach = std::max(reach, a[end_i++] + one_knot);
      else if (end_k < b.size() && b[end_k] <= reach) reach = std::max(reach, b[end_k++] + one_knot);
      else break;
    }
    const bool is_alike = end_i - i == end_k - k;
    while (i < end_i && k < end_k) {
      if (is_alike || a[i] == b[k]) found[i++] = k++;
      else ++(a[i] < b[k] ? i : k);
    }
    i = end_i;
    k = end_k;
  }
  return found;
}

/// Compares the points between two neighbors among the knots of either.
bool is_near_between(const SideWalk& a, double end_a, const SideWalk& b, double end_b) {
  const double tolerance = std::max(a.side.tolerance, b.side.tolerance);
  const int count = a.side.degree + b.side.degree + 1;
  for (int k = 0; k < count; ++k) {
    const double t = (k + 0.5) / count;
    const glm::dvec3 point = point_at(a.side, a.span, std::lerp(a.part, end_a, t));
    if (!near(point, point_at(b.side, b.span, std::lerp(b.part, end_b, t)), tolerance)) return false;
  }
  return true;
}

bool is_near_everywhere(const SideCurve& a, const SideCurve& b) {
  const auto partner = partners(a.breaks, b.breaks, std::max(a.one_knot, b.one_knot));
  SideWalk on_a{a};
  SideWalk on_b{b};
  while (!on_a.is_at_end() || !on_b.is_at_end()) {
    const bool is_one_knot = partner[on_a.span + 1] == on_b.span + 1;
    const double end_a = is_one_knot || on_a.next() <= on_b.next() ? 1.0 : on_a.part_at(on_b.next());
    const double end_b = is_one_knot || on_b.next() <= on_a.next() ? 1.0 : on_b.part_at(on_a.next());
    if (!is_near_between(on_a, end_a, on_b, end_b)) return false;
    on_a.move_to(end_a);
    on_b.move_to(end_b);
  }
  return true;
}

}  // namespace

std::optional<SideCurve> side_curve(const NurbsPatch& patch, const Panel& panel, Border border, double tolerance) {
  const Axis axis = axis_of(border);
  const Interval& range = axis == Axis::u ? panel.v : panel.u;
  const Interval& own = axis == Axis::u ? panel.u : panel.v;
  const KnotVector& knots = patch.knot_vector(across(axis));
  const int begin = knots.span_of(range.start, Side::right);
  const int end = knots.span_of(range.end, Side::left) + 1;
  const int first = knots.spans()[begin] - knots.degree();
  const int last = knots.spans()[end - 1];
  const auto points = is_at_end(border) ? isocurve_points(patch, axis, own.end, Side::left, first, last + 1)
                                        : isocurve_points(patch, axis, own.start, Side::right, first, last + 1);
  if (is_point(points, tolerance)) return {};
  const std::size_t order = knots.degree() + 1;
  std::vector<glm::dvec4> pieces(order * (end - begin));
  SideCurve side{knots.degree(),          {0.0},     std::move(pieces),
                 patch.weight_exponent(), tolerance, one_knot(knots.domain(), range)};
  for (int span = begin; span < end; ++span) {
    side.breaks.push_back((knots.span_interval(span).end - range.start) / range.length());
    const glm::dvec4* const needed = points.data() + (knots.spans()[span] - knots.degree() - first);
    write_bezier_piece(knots.bezier_matrix(span), needed, side.pieces.data() + order * (span - begin));
  }
  return side;
}

SideMiddle middle(const SideCurve& side) {
  const auto inner = std::span(side.breaks).subspan(1, side.breaks.size() - 2);
  const auto behind = std::ranges::upper_bound(inner, 0.5 + side.one_knot);
  if (behind - std::ranges::lower_bound(inner, 0.5 - side.one_knot) > 1) {
    return {place_of(0.5 * (start_of(side) + end_of(side))), 0.0};
  }
  const double place = place_of(point_at(side, 0.5));
  const auto away = [&](double t) { return std::abs(place_of(point_at(side, std::clamp(t, 0.0, 1.0))) - place); };
  return {place, std::max(away(0.5 - side.one_knot), away(0.5 + side.one_knot))};
}

bool is_one_curve(const SideCurve& a, const SideCurve& b, bool reversed) {
  if (!reversed && is_same(a, b)) return true;
  const double tolerance = std::max(a.tolerance, b.tolerance);
  if (!near(start_of(a), reversed ? end_of(b) : start_of(b), tolerance)) return false;
  if (!near(end_of(a), reversed ? start_of(b) : end_of(b), tolerance)) return false;
  return reversed ? is_near_everywhere(a, turned(b)) : is_near_everywhere(a, b);
}

}  // namespace splinecore
