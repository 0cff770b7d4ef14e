#pragma once

#include <functional>
#include <vector>

#include "section_place.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether curves end at a point whatever comes there.
using IsCurveEnd = std::function<bool(const glm::dvec3&)>;

/// Curves that go on in each other within a distance as one: whether a curve is split in a corner narrower than that
/// depends on how the patches lie. Where more than two ends are together, where patches touch, and where a curve comes back
/// in a cusp, as at a fold, curves end.
std::vector<SectionTrace> joined_traces(const TwoPatches& patches, const std::vector<SectionTrace>& traces,
                                        const IsCurveEnd& is_end, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
