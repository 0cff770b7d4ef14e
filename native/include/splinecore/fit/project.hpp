#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Writes the points of a curve at parameters.
using CurveFunction = std::function<void(std::span<const double> parameters, std::span<glm::dvec3> points)>;

/// The orthogonal projection of a function on the splines with these knots: the remainder is orthogonal to each of their
/// basis functions (lecture row S17: the integral of (f - g) times a function is zero). Integrals by 16 nodes of Gauss
/// and Legendre, or as many as the degree and 8, on a 16th of each span and on ever smaller parts of it, until these tell
/// the function: kinks, jumps and narrow peaks are found where a part's nodes and those of its halves differ. Features
/// narrower than the distances of 512 nodes in a span may be missed.
/// @param fixed_ends  the curve begins and ends where the function does: the knots are clamped
/// @returns the curve, and the largest distance that is found: from all nodes and 64 even parameters of each span uphill
/// @throws InvalidShape if a value of the function is not finite, or it is rough everywhere, as noise is.
Approximation<NurbsCurve> project(const CurveFunction& function, const KnotVector& knots, bool fixed_ends = false);

}  // namespace splinecore
