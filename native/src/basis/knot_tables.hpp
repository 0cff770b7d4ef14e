#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "kernels/kernels.hpp"
#include "scaled_knots.hpp"
#include "span_blocks.hpp"
#include "span_finder.hpp"
#include "span_tables.hpp"
#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is computed of the spans of a knot vector, once for all its copies.
class KnotTables {
  static constexpr int kOrder = 2;

  /// What SpanBlocks fill the rows of a span with.
  static auto filler(const KnotVector& knots, int order) {
    return [&knots, order](std::size_t span, double* out) {
      const double* const start = knots.unrolled().data() + knots.spans()[span];
      for (int k = 0; k <= (order > 0 ? kOrder : 0); ++k) {
        fill_derivative_table(start, knots.degree(), k, out);
        out += rows_of(knots.degree(), k) * table_width(knots.degree());
      }
    };
  }

 public:
  /// @param unrolled, spans  as of the vector that keeps both
  KnotTables(std::span<const double> unrolled, std::span<const int> spans, int degree)
      : finder(unrolled, spans),
        values_(spans.size(), rows_of(degree, 0) * table_width(degree)),
        derivatives_(spans.size(), (rows_of(degree, 0) + rows_of(degree, 1) + rows_of(degree, 2)) * table_width(degree)) {
  }

  ~KnotTables() { delete scaled_.load(); }
  KnotTables(const KnotTables&) = delete;
  KnotTables& operator=(const KnotTables&) = delete;

  /// The knots divided by a power of two, if that was kept: other knots than these, so that none keep themselves.
  const ScaledKnots* scaled() const noexcept { return scaled_.load(std::memory_order_acquire); }

  /// Of two that are kept at once the first is taken.
  const ScaledKnots& keep(ScaledKnots made) {
    auto own = std::make_unique<const ScaledKnots>(std::move(made));
    const ScaledKnots* known = nullptr;
    if (scaled_.compare_exchange_strong(known, own.get(), std::memory_order_acq_rel)) known = own.release();
    return *known;
  }

  /// Rows of a span for derivatives 0 … order, 2 at most, one after the other: see fill_derivative_table().
  const double* rows(const KnotVector& knots, int span, int order) {
    return of_order(order).of(static_cast<std::size_t>(span), filler(knots, order));
  }

  /// Those of all spans, size() numbers each, if they are few; or nullptr.
  const double* all_rows(const KnotVector& knots, int order) { return of_order(order).together(filler(knots, order)); }
  std::size_t size(int order) const noexcept { return (order > 0 ? derivatives_ : values_).size(); }

  SpanFinder finder;

 private:
  static std::size_t rows_of(int degree, int order) { return static_cast<std::size_t>(std::max(degree + 1 - order, 0)); }

  SpanBlocks& of_order(int order) { return order > 0 ? derivatives_ : values_; }

  SpanBlocks values_;
  SpanBlocks derivatives_;
  std::atomic<const ScaledKnots*> scaled_{nullptr};
};

}  // namespace splinecore
#pragma GCC visibility pop
