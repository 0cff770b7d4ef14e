#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <span>
#include <vector>

#include "base/one_sign.hpp"
#include "base/sort_by.hpp"
#include "basis/bernstein_net.hpp"
#include "basis/gaps.hpp"
#include "bezier_piece.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Parameters within which the weight is zero, up to rounding; often a single one.
using Zeros = std::vector<Interval>;

/// Zeros of a polynomial in Bernstein form on `range`, by subdivision with the hull property.
/// `noise` is the size below which a coefficient is rounding.
void find_zeros(BernsteinNet<double> piece, Interval range, double noise, Zeros& zeros) {
  if (has_one_sign(piece.values, {}, noise)) return;
  const auto [low, high] = piece.range();
  const double middle = range.middle();
  const bool all_noise = low >= -noise && high <= noise;
  if (all_noise || !(middle > range.start && middle < range.end)) {
    if (!zeros.empty() && zeros.back().end == range.start) {
      zeros.back().end = range.end;
    } else {
      zeros.push_back(range);
    }
    return;
  }
  BernsteinNet<double> right;
  piece.halve(Axis::u, right);
  find_zeros(std::move(piece), {range.start, middle}, noise, zeros);
  find_zeros(std::move(right), {middle, range.end}, noise, zeros);
}

/// The homogeneous points that the curve depends on in a span.
std::span<const glm::dvec4> span_points(const NurbsCurve& curve, int span) {
  const KnotVector& knots = curve.knot_vector();
  return curve.homogeneous_points().subspan(knots.spans()[span] - knots.degree(), knots.degree() + 1);
}

/// What rounding may leave of a weight that is zero. Nothing where all weights have one sign:
/// then no digits cancel.
double weight_noise(const NurbsCurve& curve, int span) {
  const auto points = span_points(curve, span);
  const auto [low, high] = std::ranges::minmax(points | std::views::transform(&glm::dvec4::w));
  if (low >= 0.0 || high <= 0.0) return 0.0;
  return 4.0 * static_cast<double>(points.size()) * kEpsilon * std::max(-low, high);
}

/// Around a root the weight is noise on a short stretch: that is one point at infinity.
Interval narrowed(Interval zero, Interval span) {
  constexpr double kShort = 1e-6;
  if (zero.length() >= kShort * span.length()) return zero;
  const double root = zero.start == span.start ? span.start : zero.end == span.end ? span.end : zero.middle();
  return {root, root};
}

Zeros zeros_of_weight(const NurbsCurve& curve) {
  Zeros zeros;
  if (!curve.rational()) return zeros;
  const KnotVector& knots = curve.knot_vector();
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    Zeros found;
    find_zeros(weights_of(bezier_piece(curve, i)), span, weight_noise(curve, i), found);
    for (const Interval& zero : found) zeros.push_back(narrowed(zero, span));
  }
  return zeros;
}

}  // namespace

bool is_at_infinity(const NurbsCurve& curve, double u, Side side) {
  if (!curve.rational()) return false;
  const Samples at = Samples::make(curve.knot_vector(), {&u, 1}, 0, side);
  const double w = weighted_sum(at.weights(0), curve.homogeneous_points().data() + at.first(0)).w;
  return std::abs(w) <= weight_noise(curve, curve.knot_vector().span_of(at.parameter(0), side));
}

std::vector<Interval> pieces(const NurbsCurve& curve) {
  Zeros cuts = zeros_of_weight(curve);
  for (const double u : gaps(curve.knot_vector())) cuts.push_back({u, u});
  sort_by(cuts, [](const Interval& cut) { return cut.start; });
  const Interval range = curve.domain();
  std::vector<Interval> found;
  double start = range.start;
  for (const Interval& cut : cuts) {
    if (cut.start > start) found.push_back({start, cut.start});
    start = std::max(start, cut.end);
  }
  if (start < range.end) found.push_back({start, range.end});
  return found;
}

}  // namespace splinecore
