#pragma once

#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore::fuzz {

/// A mesh made of a set, evaluated on it: what every reader of it relies on.
void check_mesh(const Tessellation& mesh, const PatchSet& set);

/// Meshes of a set, by count and adaptive ones, both of them small.
void check_small_meshes(const PatchSet& set);

}  // namespace splinecore::fuzz
