#pragma once

#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Numbers from begin up to end.
struct Range {
  int begin;
  int end;
  friend bool operator==(const Range&, const Range&) = default;
};

/// Spans of both directions, as numbers in KnotVector::spans().
struct SpanRectangle {
  Range u;
  Range v;
};

/// All spans of a patch.
SpanRectangle all_spans(const NurbsPatch& patch);

/// The spans on which a patch may differ from one on the same knot vectors: disjoint, growing along u. Points that
/// agree in every bit are equal.
std::vector<SpanRectangle> moved_spans(const NurbsPatch& patch, const NurbsPatch& before);

}  // namespace splinecore
#pragma GCC visibility pop
