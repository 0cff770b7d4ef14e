#pragma once

#include "mesh_topology.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The bicubic Bezier patch over [0, 1]² to which a face with four regular corners converges: u along a side of it, v from
/// there inwards. Beyond borders points are reflected, which makes these cubic splines.
NurbsPatch regular_patch(const ControlMesh& mesh, const MeshTopology& topology, int side);

}  // namespace splinecore
#pragma GCC visibility pop
