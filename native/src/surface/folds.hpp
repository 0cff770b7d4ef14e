#pragma once

#include "mesh_topology.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether a mesh has a point inside where two faces meet that lie on each other's edges: a surface has no tangent plane there.
bool has_folds(const MeshTopology& topology);

/// A mesh of four-sided faces without such points: both faces there become one.
ControlMesh without_folds(const ControlMesh& mesh, const MeshTopology& topology);

}  // namespace splinecore
#pragma GCC visibility pop
