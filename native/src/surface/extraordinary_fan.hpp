#pragma once

#include <vector>

#include "mesh_topology.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The patches of the faces about an extraordinary point, in the order of its fan. u of each runs along the side that begins
/// at the corner across from the point.
/// @param finer  the mesh subdivided once more, by which the surface is known everywhere but at the point
std::vector<NurbsPatch> extraordinary_fan(const ControlMesh& mesh, const MeshTopology& topology, const ControlMesh& finer,
                                          const MeshTopology& finer_topology, int point);

}  // namespace splinecore
#pragma GCC visibility pop
