#pragma once

#include "splinecore/build/offset.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// offset(), and none where nothing is left.
std::vector<NurbsCurve> offset_parts(const NurbsCurve& curve, double distance, const OffsetOptions& options);

}  // namespace splinecore
#pragma GCC visibility pop
