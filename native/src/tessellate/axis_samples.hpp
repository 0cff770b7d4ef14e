#pragma once

#include <vector>

#include "mesh_spans.hpp"
#include "splinecore/basis/samples.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Where one direction of a patch is sampled: on lines, each with one sample or two.
///
/// Knots at which the derivative may jump, creases, are sampled from both sides on one line; where the patch
/// itself has a gap they are two lines.
struct AxisSamples {
  Samples samples;
  std::vector<int> first;        ///< of each line: its sample seen from before
  std::vector<int> last;         ///< and the one seen from behind
  std::vector<int> span_starts;  ///< of each mesh span: the line it begins on

  int line_count() const noexcept { return static_cast<int>(first.size()); }
  bool is_crease(int line) const noexcept { return first[line] != last[line]; }
};

/// `resolution` strips of equal width in every one of the spans, which are mesh_spans(knots).
AxisSamples sample_axis(const KnotVector& knots, const std::vector<MeshSpan>& spans, int resolution);

}  // namespace splinecore
#pragma GCC visibility pop
