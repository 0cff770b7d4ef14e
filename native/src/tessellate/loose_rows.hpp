#pragma once

#include <vector>

#include "splinecore/patch/panels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of each row of the pool, whether moving it may part sides that are one edge, or open one that is a point.
///
/// Sides stay one that run along the same rows of the pool on the same scaled knots; a side of one row stays a point.
std::vector<char> loose_rows(const PatchSet& set, const std::vector<Panel>& panels);

}  // namespace splinecore
#pragma GCC visibility pop
