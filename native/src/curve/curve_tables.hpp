#pragma once

#include <memory>

#include "basis/span_blocks.hpp"
#include "kernels/kernels.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The Bernstein coefficients of a curve's spans, for the kernels: its own, and those of its first two derivatives.
class CurveTables {
 public:
  CurveTables(std::size_t spans, int degree)
      : points_(spans, 4 * rows_to(degree, 0)), derivatives_(spans, 4 * rows_to(degree, 2)) {}

  /// The half of a span that a parameter lies in. @param order  of the highest derivative wanted, 2 at most
  CurveHalf half(const NurbsCurve& curve, int span, bool is_second, int order);

 private:
  /// How many rows the derivatives 0 … order have.
  static std::size_t rows_to(int degree, int order);

  SpanBlocks points_;
  SpanBlocks derivatives_;
};

/// Whether a parameter of a span is nearer to the end.
inline bool is_in_second_half(const Interval& span, double u) { return u > span.middle() || u == span.end; }

}  // namespace splinecore
