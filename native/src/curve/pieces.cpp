#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Parameters within which the weight is zero, up to rounding; often a single one.
using Zeros = std::vector<Interval>;

/// The first half of de Casteljau's triangle stays in `coefficients`, the second is returned.
std::vector<double> halve(std::vector<double>& coefficients) {
  const std::size_t order = coefficients.size();
  std::vector<double> right(order);
  for (std::size_t level = 0; level < order; ++level) {
    right[order - 1 - level] = coefficients[order - 1];
    for (std::size_t i = order - 1; i > level; --i) {
      coefficients[i] = 0.5 * (coefficients[i - 1] + coefficients[i]);
    }
  }
  return right;
}

/// Zeros of a polynomial in Bernstein form on `range`, by subdivision with the hull property.
/// `noise` is the size below which a coefficient is rounding.
void find_zeros(std::vector<double> coefficients, Interval range, double noise, Zeros& zeros) {
  const auto [low, high] = std::ranges::minmax(coefficients);
  if (low > noise || high < -noise) return;
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
  const std::vector<double> right = halve(coefficients);
  find_zeros(std::move(coefficients), {range.start, middle}, noise, zeros);
  find_zeros(right, {middle, range.end}, noise, zeros);
}

std::vector<double> span_weights(const NurbsCurve& curve, int span) {
  const KnotVector& knots = curve.knot_vector();
  const auto matrix = knots.bezier_matrix(span);
  const int order = knots.degree() + 1;
  const glm::dvec4* points = curve.homogeneous_points().data() + knots.spans()[span] - knots.degree();
  std::vector<double> weights(order);
  for (int j = 0; j < order; ++j) {
    for (int i = 0; i < order; ++i) weights[j] += matrix[j * order + i] * points[i].w;
  }
  return weights;
}

Zeros zeros_of_weight(const NurbsCurve& curve) {
  Zeros zeros;
  if (!curve.rational()) return zeros;
  double largest = 0.0;
  for (const glm::dvec4& p : curve.points()) largest = std::max(largest, std::abs(p.w));
  const double noise = 4.0 * (curve.degree() + 1) * kEpsilon * largest;
  const KnotVector& knots = curve.knot_vector();
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    find_zeros(span_weights(curve, i), knots.span_interval(i), noise, zeros);
  }
  return zeros;
}

/// Parameters strictly inside the domain where the curve may jump.
std::vector<double> gaps(const KnotVector& knots) {
  std::vector<double> found;
  for (const int k : knots.spans()) {
    const double u = knots.unrolled()[k];
    if (u > knots.domain().start && multiplicity(knots, u) > knots.degree()) found.push_back(u);
  }
  return found;
}

}  // namespace

std::vector<Interval> pieces(const NurbsCurve& curve) {
  Zeros cuts = zeros_of_weight(curve);
  for (const double u : gaps(curve.knot_vector())) cuts.push_back({u, u});
  std::ranges::sort(cuts, {}, &Interval::start);
  const Interval range = curve.domain();
  // Around a root the weight is noise on a short stretch: that is one point at infinity.
  constexpr double kShort = 1e-6;
  std::vector<Interval> found;
  double start = range.start;
  for (Interval cut : cuts) {
    if (cut.length() < kShort * range.length()) {
      const bool at_start = cut.start == range.start;
      const bool at_end = cut.end == range.end;
      cut.start = cut.end = at_start ? range.start : at_end ? range.end : cut.middle();
    }
    if (cut.start > start) found.push_back({start, cut.start});
    start = std::max(start, cut.end);
  }
  if (start < range.end) found.push_back({start, range.end});
  return found;
}

}  // namespace splinecore
