#pragma once

#include <vector>

#include "apex.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether sides go on into each other at all corners.
bool is_round(const Hole& hole);

/// Sets how the sides of a round hole leave for the apex, and so that both of a corner do so alike there, and change alike.
void agree_round(Hole& hole, const Apex& apex);

/// Patches between the sides of a round hole and its apex, in which v of all ends: v_start of each is a side, u_end the next
/// one's u_start. Sides are what they are, weights and all; what leaves them does so as given at
/// interpolation_places_between_slopes().
/// @param degree  along the sides, at least theirs
std::vector<NurbsPatch> round_filling(const Hole& hole, const Apex& apex, int degree);

}  // namespace splinecore
#pragma GCC visibility pop
