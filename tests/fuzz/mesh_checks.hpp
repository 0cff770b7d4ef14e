#pragma once

#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore::fuzz {

/// A mesh made of a set, evaluated on it: what every reader of it relies on.
void check_mesh(const Tessellation& mesh, const PatchSet& set);

/// Small meshes of a set: by count, and where asked for, which takes a hundred times as long, an adaptive one.
void check_small_meshes(const PatchSet& set, bool is_adaptive);

}  // namespace splinecore::fuzz
