#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The unit normal of the plane that the control points lie in, up to 1e-9 of their extent: towards +z, or across z
/// towards +y, or +x. Of points on one line it is that of the coordinate plane that fits best.
/// @throws InvalidShape if they lie in no plane, with how far they are off it.
glm::dvec3 plane_normal(const NurbsCurve& curve);

/// The parameters, in order, where the curve, seen against a direction, begins to bend to the other side (S15). Of a
/// straight part between two bends it is the middle. A corner is none.
///
/// Roots of the numerator of the signed curvature, a polynomial on every span, by halving (bernstein_zeros).
/// @throws InvalidShape if the direction is zero or not finite.
std::vector<double> inflections(const NurbsCurve& curve, const glm::dvec3& direction);

/// The parameters, in order, where the curve moves neither along the direction nor against it, or turns about there:
/// roots of the derivative, both ends of a part that is at right angles, corners where it changes sign, and the ends
/// of the curve and of its pieces.
/// @throws InvalidShape if the direction is zero or not finite; PointAtInfinity if the curve runs to infinity.
std::vector<double> extrema(const NurbsCurve& curve, const glm::dvec3& direction);

}  // namespace splinecore
