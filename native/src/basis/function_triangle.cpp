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

/// 0 where a knot interval is empty: 0/0 = 0.
double share(double part, double whole) { return whole == 0.0 ? 0.0 : part / whole; }

/// The functions of one degree more than those of `below`, on span k.
TriangleRow next_row(std::span<const double> knots, int k, int degree, double u, const TriangleRow& below) {
  TriangleRow row;
  row.first = std::max(0, k - degree);
  const int last = std::min(k, static_cast<int>(knots.size()) - degree - 2);
  const auto value_below = [&](int i) {
    const int j = i - below.first;
    return j >= 0 && j < static_cast<int>(below.values.size()) ? below.values[j] : 0.0;
  };
  for (int i = row.first; i <= last; ++i) {
    const double rising = share(u - knots[i], knots[i + degree] - knots[i]);
    const double falling = share(knots[i + degree + 1] - u, knots[i + degree + 1] - knots[i + 1]);
    row.rising.push_back(rising);
    row.falling.push_back(falling);
    row.values.push_back(rising * value_below(i) + falling * value_below(i + 1));
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
