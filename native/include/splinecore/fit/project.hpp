#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Writes the points of a curve at parameters.
using CurveFunction = std::function<void(std::span<const double> parameters, std::span<glm::dvec3> points)>;

/// The orthogonal projection of a function on the splines with these knots: what is left is orthogonal to each of their
/// basis functions (lecture row S17: the integral of (f - g) times a function is zero). Integrals by 16 nodes of Gauss
/// and Legendre on each span, or as many as the degree and 8: the function is taken to be smooth between knots.
/// @param fixed_ends  the curve begins and ends where the function does: the knots are clamped
/// @returns the curve, and the largest distance found at the nodes and at 64 even parameters of each span
/// @throws InvalidShape if a value of the function is not finite.
Approximation<NurbsCurve> project(const CurveFunction& function, const KnotVector& knots, bool fixed_ends = false);

}  // namespace splinecore
