#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "kernels/kernels.hpp"
#include "span_blocks.hpp"
#include "span_finder.hpp"
#include "span_tables.hpp"
#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// What is computed of the spans of a knot vector, once for all its copies.
class KnotTables {
 public:
  KnotTables(std::size_t spans, int degree, std::vector<double> starts, double end)
      : finder(std::move(starts), end),
        matrices(spans, (static_cast<std::size_t>(degree) + 1) * (static_cast<std::size_t>(degree) + 1)),
        derivatives{{spans, rows_of(degree, 0)}, {spans, rows_of(degree, 1)}, {spans, rows_of(degree, 2)}} {}

  /// Rows of a span for derivative `order`: see fill_derivative_table().
  const double* derivative_rows(const KnotVector& knots, int span, int order) {
    return derivatives[order].of(static_cast<std::size_t>(span), [&](std::size_t which, double* out) {
      fill_derivative_table(knots.unrolled().data() + knots.spans()[which], knots.degree(), order, out);
    });
  }

  SpanFinder finder;
  SpanBlocks matrices;
  SpanBlocks derivatives[3];

 private:
  static std::size_t rows_of(int degree, int order) {
    return static_cast<std::size_t>(std::max(degree + 1 - order, 0)) * table_width(degree);
  }
};

}  // namespace splinecore
