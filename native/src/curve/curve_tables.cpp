#include "curve_tables.hpp"

#include <algorithm>

#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

namespace {

/// Writes the coefficients, each times its binomial, of the derivatives 0 … order on a span.
void fill_rows(const NurbsCurve& curve, std::size_t span, int order, double* out) {
  const KnotVector& knots = curve.knot_vector();
  const int degree = knots.degree();
  const std::size_t width = table_width(degree);
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  const glm::dvec4* points = curve.homogeneous_points().data() + knots.spans()[span] - degree;
  for (int k = 0; k <= std::min(order, degree); ++k) {
    const double* table = knots.derivative_table(static_cast<int>(span), k);
    breathe(4 * count * count);
    for (int j = 0; j <= degree - k; ++j, table += width, out += 4) {
      const glm::dvec4 sum = binomial(degree - k, j) * weighted_sum({table, count}, points);
      for (int axis = 0; axis < 4; ++axis) out[axis] = sum[axis];
    }
  }
}

}  // namespace

std::size_t CurveTables::rows_to(int degree, int order) {
  std::size_t rows = 0;
  for (int k = 0; k <= order; ++k) rows += static_cast<std::size_t>(std::max(degree + 1 - k, 0));
  return rows;
}

CurveHalf CurveTables::half(const NurbsCurve& curve, int span, bool is_second, int order) {
  const auto fill = [&](std::size_t which, double* out) { fill_rows(curve, which, order > 0 ? 2 : 0, out); };
  const double* rows = (order > 0 ? derivatives_ : points_).of(static_cast<std::size_t>(span), fill);
  const Interval range = curve.knot_vector().span_interval(span);
  if (!is_second) return {range.start, range.end, rows, 4};
  return {range.end, range.start, rows + 4 * curve.degree(), -4};
}

}  // namespace splinecore
