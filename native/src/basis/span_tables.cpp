#include "span_tables.hpp"

#include <algorithm>
#include <vector>

#include "blossom.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// Whether the span that begins at *start is a Bezier piece: all knots about it are its ends.
bool is_bezier(const double* start, int degree) {
  return degree > 0 && start[1 - degree] == start[0] && start[1] == start[degree];
}

}  // namespace

void differentiate(const double* start, int lower, std::span<double> weights) {
  const int degree = static_cast<int>(weights.size()) - 1;
  for (int p = lower + 1; p <= degree; ++p) {
    double carried = 0.0;
    for (int j = 0; j < p; ++j) {
      const double slope = p * weights[j] / (start[j + 1] - start[j + 1 - p]);
      weights[j] = carried - slope;
      carried = slope;
    }
    weights[p] = carried;
  }
}

void fill_derivative_table(const double* start, int degree, int order, double* out) {
  const std::size_t width = table_width(degree);
  const int lower = degree - order;
  const bool is_piece = is_bezier(start, degree);
  std::vector<double> arguments(std::max(lower, 0), start[0]);
  for (int j = 0; j <= lower; ++j, out += width) {
    if (j > 0) arguments[j - 1] = start[1];
    breathe(4 * width * (is_piece ? 1 : width));
    std::fill_n(out, width, 0.0);
    if (is_piece) {
      out[j] = 1.0;
    } else {
      blossom_weights(start - lower, lower, arguments, out);
    }
    if (order > 0) differentiate(start, lower, {out, static_cast<std::size_t>(degree) + 1});
  }
}

}  // namespace splinecore
