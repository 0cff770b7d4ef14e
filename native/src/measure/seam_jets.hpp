#pragma once

#include <span>
#include <vector>

#include "flank.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Both sides of a seam at the same places, in their order.
struct SeamJets {
  std::vector<SeamPlace> places;
  std::vector<SeamJet> a;
  std::vector<SeamJet> b;
};

/// What is measured at one place: 0 where all is well; NaN where there is nothing to measure.
using SeamMeasure = double (*)(const SeamJet& a, const SeamJet& b);

SeamJets seam_jets(const Flank& a, const Flank& b, std::vector<SeamPlace> places, SeamDepth depth);

/// At places that lie close in every span of either side, its ends included, and closer where a measure is largest, or nearly so: there to
/// a five-hundredth of the way between.
SeamJets dense_seam_jets(const Flank& a, const Flank& b, SeamDepth depth, std::span<const SeamMeasure> measures);

/// The largest of a measure, as nearly.
double largest_along(const Flank& a, const Flank& b, SeamDepth depth, SeamMeasure measure);

}  // namespace splinecore
#pragma GCC visibility pop
