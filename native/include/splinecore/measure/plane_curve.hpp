#pragma once

#include <glm/vec3.hpp>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// To which part of what the line from its middle sweeps the area of a curve is found unless asked otherwise.
inline constexpr double kPlaneAreaTolerance = 1e-12;

/// The area within a closed curve, seen against the normal of its plane: positive where it lies to the left,
/// parts within two turns count twice (Green's theorem). Of a curve in another plane, or in none, it is that of the
/// projected curve.
///
/// Of a polynomial span it is the mean of Bernstein coefficients; of a rational one by the rules of Gauss and Kronrod of
/// 15 and 31 nodes, halved where they differ and where weights differ much.
/// @throws InvalidShape if the normal is zero, the tolerance not positive, the curve in several pieces, or its ends
///         farther apart than 1e-9 of its size; PointAtInfinity; ToleranceNotReached.
Approximation<double> signed_area(const NurbsCurve& curve, const glm::dvec3& normal,
                                  double tolerance = kPlaneAreaTolerance);

/// How often a closed curve winds around a point, to the left, seen against the normal: the crossings of a ray, which are
/// all roots of a polynomial on every span.
/// @throws InvalidShape if the point lies on the curve, up to 1e-12 of its size; and as signed_area().
int winding_number(const NurbsCurve& curve, const glm::dvec3& point, const glm::dvec3& normal);

}  // namespace splinecore
