#include "curve_tables.hpp"

#include <algorithm>

#include "basis/knot_tables.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

void fill_rows(const NurbsCurve& curve, std::size_t span, int order, double* out) {
  const KnotVector& knots = curve.knot_vector();
  const int degree = knots.degree();
  const std::size_t width = table_width(degree);
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  const glm::dvec4* points = curve.homogeneous_points().data() + knots.spans()[span] - degree;
  const double* table = knots.tables().rows(knots, static_cast<int>(span), order);
  const int orders = std::min(order, degree);
  double* from_end = out + 4 * rows_to(degree, order);
  for (int k = 0; k <= orders; ++k) {
    breathe(4 * count * count);
    const int last = degree - k;
    for (int j = 0; j <= last; ++j, table += width) {
      const glm::dvec4 sum = binomial(last, j) * weighted_sum({table, count}, points);
      for (int axis = 0; axis < 4; ++axis) out[4 * j + axis] = from_end[4 * (last - j) + axis] = sum[axis];
    }
    out += 4 * (last + 1);
    from_end += 4 * (last + 1);
  }
}

}  // namespace splinecore
