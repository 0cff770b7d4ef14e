#pragma once

#include "near_space.hpp"
#include "patch_march.hpp"
#include "splinecore/meet/sections.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The cubics of a trace as curves on one knot vector.
SectionCurve section_curve(const SectionTrace& trace, const TwoPatches& patches, const NearSpace& space);

}  // namespace splinecore
#pragma GCC visibility pop
