#pragma once

#include "knot_tables.hpp"

namespace splinecore {

/// An admitted parameter on a span for kernels that want derivatives up to `order`, 2 at most.
inline BasisPlace place_in(const KnotVector& knots, int span, double u, int order) {
  const Interval range = knots.span_interval(span);
  BasisPlace place{{}, (u - range.start) / range.length(), (range.end - u) / range.length()};
  for (int k = 0; k <= order; ++k) place.rows[k] = knots.tables().derivative_rows(knots, span, k);
  return place;
}

}  // namespace splinecore
