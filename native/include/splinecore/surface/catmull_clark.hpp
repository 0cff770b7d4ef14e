#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A net of faces whose corners are numbers of points, counterclockwise seen from outside.
struct ControlMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<int>> faces;
};

/// Patches of the surface to which a mesh converges.
struct SubdivisionPatches {
  std::vector<NurbsPatch> patches;  ///< one for each face of the mesh that was subdivided `rounds` times, in its order, but for points inside with two faces
  int rounds = 0;
  std::size_t irregular = 0;        ///< patches that are not the surface itself: beside an extraordinary point
  double angle = 0.0;               ///< the largest between tangent planes across a side of one of these
};

/// Catmull and Clark's scheme: each face becomes one of four-sided faces round its middle, and points move to means of those
/// about them; edges that have one face converge to a cubic spline, and corners of one face stay (Catmull and Clark 1978).
ControlMesh subdivided(const ControlMesh& mesh);

/// The surface of Catmull and Clark's scheme. A mesh is subdivided until all its faces have four sides and at most one
/// extraordinary point. A face without one is a bicubic Bezier patch: exactly that of the surface (Catmull and Clark 1978).
/// Those about an extraordinary point are patches of degree 7 that pass through its limit, with the normal of the surface
/// there (Halstead, Kass and DeRose 1993); where more than three faces meet on the border the scheme has none. They continue
/// the curvatures round about and meet each other in common tangent planes, with least third derivatives: near the surface,
/// but not on it. A point inside with two faces, where the scheme has no tangent plane, is left out after the first round;
/// its faces become one.
/// @throws InvalidShape naming faces or points, if there is no face, a face has fewer than three corners or one twice, a
///         corner is no point, an edge has more than two faces, faces beside each other are turned differently, parts of
///         the mesh meet in a point alone, or a point inside has one face alone.
SubdivisionPatches catmull_clark(const ControlMesh& mesh);

}  // namespace splinecore
