#pragma once

#include <algorithm>
#include <cstddef>

#include "basis/span_blocks.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How many rows the derivatives 0 … order have together.
inline std::size_t rows_to(int degree, int order) {
  std::size_t rows = 0;
  for (int k = 0; k <= order; ++k) rows += static_cast<std::size_t>(std::max(degree + 1 - k, 0));
  return rows;
}

/// Writes the Bernstein coefficients, each times its binomial, of the derivatives 0 … order on a span: once from its start
/// on and once from its end on.
void fill_rows(const NurbsCurve& curve, std::size_t span, int order, double* out);

/// The coefficients of the halves of a curve's spans, for the kernels: its own, and those with its first two derivatives.
class CurveTables {
  static constexpr int kOrder = 2;

  static auto filler(const NurbsCurve& curve, int order) {
    return [&curve, order](std::size_t span, double* out) { fill_rows(curve, span, order > 0 ? kOrder : 0, out); };
  }

 public:
  CurveTables(std::size_t spans, int degree)
      : points_(spans, 8 * rows_to(degree, 0)), derivatives_(spans, 8 * rows_to(degree, kOrder)) {}

  /// The coefficients of a half of a span. @param order  of the highest derivative wanted, 2 at most
  const double* rows(const NurbsCurve& curve, int half, int order) {
    return of_order(order).of(static_cast<std::size_t>(half >> 1), filler(curve, order)) + (half & 1) * size(order);
  }

  /// Those of all halves, size() numbers each, if they are few; or nullptr.
  const double* all_rows(const NurbsCurve& curve, int order) { return of_order(order).together(filler(curve, order)); }
  std::size_t size(int order) { return of_order(order).size() / 2; }

 private:
  SpanBlocks& of_order(int order) { return order > 0 ? derivatives_ : points_; }

  SpanBlocks points_;
  SpanBlocks derivatives_;
};

}  // namespace splinecore
#pragma GCC visibility pop
