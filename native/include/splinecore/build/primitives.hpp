#pragma once

#include "splinecore/build/sweeps.hpp"

namespace splinecore {

// Exact patches of the usual shapes (The NURBS Book, 8.3 and 8.5; lecture row S20).
//
// About an axis, u is the longitude and v runs as said below; the angle 0 lies in the direction of x where the axis is
// that of z, otherwise where plane_across() has its x axis. Normals point outwards for a sweep that is
// positive. A whole turn is periodic in u: eight points around. All throw InvalidShape naming what is not finite, no
// positive length, an axis without direction, or a sweep that is zero or more than a whole turn.

/// origin + u axis_a + v axis_b over [0, 1]²; the normal is along axis_a x axis_b.
/// @throws InvalidShape if the axes are zero or parallel.
NurbsPatch plane(const glm::dvec3& origin, const glm::dvec3& axis_a, const glm::dvec3& axis_b);

/// The mantle of a cylinder; v from 0 to 1 rises from the circle about `center` by `height`.
NurbsPatch cylinder(const glm::dvec3& center, const glm::dvec3& axis, double radius, double height, Turn turn = {});

/// The mantle of a cone, from the circle about `center` to that of `top_radius` at `height`, or to the tip: a pole.
/// @throws InvalidShape if a radius is below 0 or both are 0.
NurbsPatch cone(const glm::dvec3& center, const glm::dvec3& axis, double radius, double height, double top_radius = 0.0,
                Turn turn = {});

/// A flat disc with its pole in the middle, v from the rim to the middle; the normal is the axis.
NurbsPatch disc(const glm::dvec3& center, const glm::dvec3& axis, double radius, Turn turn = {});

/// A sphere; v from 0 to 2 is the latitude from the south to the north pole, two edges that are points.
NurbsPatch sphere(const glm::dvec3& center, double radius, const glm::dvec3& axis = {0.0, 0.0, 1.0}, Turn turn = {});

/// A torus about the axis: a circle of `tube_radius`, whose middle runs on a circle of `ring_radius`. v is periodic; it
/// begins on the outer equator and rises. A tube thicker than the ring meets itself.
NurbsPatch torus(const glm::dvec3& center, const glm::dvec3& axis, double ring_radius, double tube_radius,
                 Turn turn = {});

}  // namespace splinecore
