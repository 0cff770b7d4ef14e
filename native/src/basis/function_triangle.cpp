#include <algorithm>
#include <cmath>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/functions.hpp"

namespace splinecore {

namespace {

/// Index k of the span with knots[k] <= u < knots[k + 1], or at the end of the domain the one before it.
int span_on_line(const KnotVector& knots, double u) {
  const auto all = knots.unrolled();
  if (knots.has_domain() && u == knots.domain().end) return knots.spans().back();
  if (!(u >= all.front() && u < all.back())) {
    throw InvalidShape("u = " + text_of(u) + " is outside [" + text_of(all.front()) + ", " + text_of(all.back()) + ")");
  }
  return static_cast<int>(std::ranges::upper_bound(all, u) - all.begin()) - 1;
}

/// The functions of one degree more than those of `below`, on span k.
TriangleRow next_row(std::span<const double> knots, int k, int degree, double u, const TriangleRow& below) {
  TriangleRow row;
  row.first = std::max(0, k - degree);
  const int last = std::min(k, static_cast<int>(knots.size()) - degree - 2);
  const int end = below.first + static_cast<int>(below.values.size());
  const auto is_fed = [&](int i) { return i >= below.first && i < end; };
  for (int i = row.first; i <= last; ++i) {
    // A function that is not zero here has knots on both sides of u, so neither divisor is zero.
    const double rising = is_fed(i) ? (u - knots[i]) / (knots[i + degree] - knots[i]) : 0.0;
    const double falling =
        is_fed(i + 1) ? (knots[i + degree + 1] - u) / (knots[i + degree + 1] - knots[i + 1]) : 0.0;
    row.rising.push_back(rising);
    row.falling.push_back(falling);
    row.values.push_back((is_fed(i) ? rising * below.values[i - below.first] : 0.0) +
                         (is_fed(i + 1) ? falling * below.values[i + 1 - below.first] : 0.0));
  }
  return row;
}

}  // namespace

std::vector<TriangleRow> function_triangle(const KnotVector& knots, double u) {
  if (!std::isfinite(u)) throw InvalidShape("u = " + text_of(u) + " is not finite");
  if (knots.periodic()) u = knots.admit(u, Side::right);
  const int k = span_on_line(knots, u);
  std::vector<TriangleRow> rows{{k, {1.0}, {}, {}}};
  for (int degree = 1; degree <= knots.degree(); ++degree) {
    rows.push_back(next_row(knots.unrolled(), k, degree, u, rows.back()));
  }
  return rows;
}

}  // namespace splinecore
