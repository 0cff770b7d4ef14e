#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Derivatives 0, 1, … of a curve at one parameter: its place, its first derivative, and so on.
struct Osculation {
  double parameter;
  std::vector<glm::dvec3> derivatives;
};

/// The one polynomial curve that has all these derivatives, on [first, last parameter] (lecture row S3).
///
/// Newton's form with repeated nodes in Leja's order (Reichel 1990), with 32 digits, brought to Bernstein
/// form. That is one span, unless its control points would be more than a thousand times larger than
/// the points and the curve, so that their rounding would be seen: then the same polynomial is returned in
/// spans that are halved until they are not. Degree: as many derivatives as are given, less one.
/// @throws InvalidShape if there are fewer than 2 parameters, they do not increase, a parameter has no
///         point, a number is not finite, the degree would pass kMaxDegree, or the points overflow.
NurbsCurve osculating_polynomial(std::span<const Osculation> data);

/// osculating_polynomial() of points alone: Lagrange's polynomial.
/// @param parameters  one for each point, increasing; empty means equal steps from 0 to 1
NurbsCurve polynomial_through(std::span<const glm::dvec3> points, std::vector<double> parameters = {});

/// Lagrange's polynomial at parameters of its domain, without a curve between: the barycentric form (Berrut and
/// Trefethen 2004, eq. 4.2), stable also where the parameters are those of Chebyshev and many. At a
/// parameter of a point it is that point in every bit.
/// @throws InvalidShape as polynomial_through() does, but for the degree, or if a parameter lies outside or the
///         polynomial overflows there.
void lagrange_evaluate(std::span<const glm::dvec3> points, std::vector<double> parameters,
                       std::span<const double> at, std::span<glm::dvec3> out);

}  // namespace splinecore
