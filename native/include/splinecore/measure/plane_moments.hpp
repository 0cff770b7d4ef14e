#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/measure/moments.hpp"
#include "splinecore/measure/plane_curve.hpp"

namespace splinecore {

/// The sum of the areas that closed curves run around, seen against a normal: those that run to the right are holes.
/// @throws as signed_area()
Approximation<double> enclosed_area(std::span<const NurbsCurve> outlines, const glm::dvec3& normal, double tolerance = kPlaneAreaTolerance);

/// The centroid of what closed curves of one plane enclose, each as often as it runs around them, seen against the normal of the plane:
/// by Green's theorem, and the rules of signed_area().
/// @param tolerance  It is off by at most so much of half the diagonal of the box of the points, or by rounding.
/// @throws InvalidShape if the curves are not in one plane with this normal, or enclose no area; and as signed_area()
Approximation<glm::dvec3> plane_centroid(std::span<const NurbsCurve> outlines, const glm::dvec3& normal,
                                         double tolerance = kPlaneAreaTolerance);

/// The second moments of that area: the integral of d d^T, where d is the way from a point, or from the centroid if there is none.
/// @param tolerance  Those about the centroid are off by at most so much of their trace, or by rounding.
/// @throws InvalidShape also if the point is not finite or a moment too large for a number
Approximation<SecondMoments> plane_second_moments(std::span<const NurbsCurve> outlines, const glm::dvec3& normal,
                                                  std::optional<glm::dvec3> about = {}, double tolerance = kPlaneAreaTolerance);

}  // namespace splinecore
