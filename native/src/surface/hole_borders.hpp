#pragma once

#include "bicubic_sum.hpp"
#include "hole.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The sides of a hole that has four, as the borders of a patch, and how it goes on from neighbors: D, nearly.
BorderPairs hole_borders(const Hole& hole);

}  // namespace splinecore
#pragma GCC visibility pop
