#pragma once

#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// Whether every side of every patch is a pole, lies across a closed direction, or lies on another side: whichever way
/// normals point.
bool is_closed(const PatchSet& set);

/// The patches of a set with normals that agree from each to its neighbors, and point outwards where the set is closed: those that
/// point the other way are seen from the other side, u and v exchanged. Of patches that hang together but are open the
/// first one stays. The pool of points is the same.
/// @throws InvalidShape naming an edge where more than two sides meet, or from which the normals come back the other way,
///         as on a band with half a turn; of closed ones as volume(), and if they enclose nothing.
PatchSet oriented(const PatchSet& set);

}  // namespace splinecore
