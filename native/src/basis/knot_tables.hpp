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

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is computed of the spans of a knot vector, once for all its copies.
class KnotTables {
  /// What SpanBlocks fill the rows of a span with.
  static auto filler(const KnotVector& knots, int order) {
    return [&knots, order](std::size_t span, double* out) {
      fill_derivative_table(knots.unrolled().data() + knots.spans()[span], knots.degree(), order, out);
    };
  }

 public:
  KnotTables(std::size_t spans, int degree, std::vector<double> starts, double end)
      : finder(std::move(starts), end),
        matrices(spans, (static_cast<std::size_t>(degree) + 1) * (static_cast<std::size_t>(degree) + 1)),
        derivatives{{spans, rows_of(degree, 0)}, {spans, rows_of(degree, 1)}, {spans, rows_of(degree, 2)}} {}

  /// Rows of a span for derivative `order`: see fill_derivative_table().
  const double* derivative_rows(const KnotVector& knots, int span, int order) {
    return derivatives[order].of(static_cast<std::size_t>(span), filler(knots, order));
  }

  /// Those of all spans, derivatives[order].size() numbers each, if they are few; or nullptr.
  const double* all_derivative_rows(const KnotVector& knots, int order) {
    return derivatives[order].together(filler(knots, order));
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
#pragma GCC visibility pop
