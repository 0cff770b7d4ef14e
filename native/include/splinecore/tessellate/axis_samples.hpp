#pragma once

#include <vector>

#include "splinecore/basis/samples.hpp"

namespace splinecore {

/// Where one direction of a patch is sampled, and which samples are one line of vertices.
///
/// Knots at which the derivative may jump are sampled from both sides. The two samples lie on
/// one line, or on two where the patch itself has a gap. The end of a periodic direction lies on
/// its first line.
struct AxisSamples {
  Samples samples;
  std::vector<int> line;            ///< of each sample
  std::vector<bool> face_follows;   ///< the strip from this sample to the next is drawn
  int line_count = 0;
};

/// `resolution` strips of equal width in every span; a periodic direction has three at least.
AxisSamples sample_axis(const KnotVector& knots, int resolution);

}  // namespace splinecore
