#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The point of a curve that is nearest to another one.
struct NearestOnCurve {
  double parameter;
  glm::dvec3 point;
  double distance;
};

/// The point of a patch that is nearest to another one.
struct NearestOnPatch {
  double u;
  double v;
  glm::dvec3 point;
  double distance;
};

/// For each point the nearest one of all the curve, its ends, corners and gaps included: the least distance, right to a
/// few roundings of the size of the shape and of itself.
///
/// Branch and bound on the boxes of Bernstein pieces (Johnson and Cohen 1998), with Newton's method. Of places at one
/// distance, up to rounding, it is the one with the smallest parameter (to 1e-6 of the domain), of a periodic curve in
/// [start, end). Where the curve passes through infinity its finite part counts. At a gap the point is that of the
/// nearer side. Any number of threads gives the same bits. Where more than 2^14 parts may hold the point, as where a
/// whole curve of places is as near that is none of constant u or v, or weights are wildly different, the first place
/// is not looked for, and the distance is right to 1e-7 of that size.
/// @param out  as many as points
/// @param threads  0: as many as are worth it
/// @throws InvalidShape naming a point that is not finite, or too far away; or after 2^18 such parts; PointAtInfinity if
///         the whole curve is.
void nearest(const NurbsCurve& curve, std::span<const glm::dvec3> points, std::span<NearestOnCurve> out,
             int threads = 0);

/// The same on a patch, borders and corners included: of places at one distance the one with the smallest u, then v.
void nearest(const NurbsPatch& patch, std::span<const glm::dvec3> points, std::span<NearestOnPatch> out,
             int threads = 0);

}  // namespace splinecore
