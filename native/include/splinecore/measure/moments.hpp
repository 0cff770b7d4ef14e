#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "splinecore/measure/area.hpp"

namespace splinecore {

/// The integrals of the products of two coordinates over a solid: rows of a symmetric matrix.
using SecondMoments = std::array<glm::dvec3, 3>;

/// The centroid of the solid that a closed set of patches encloses: an integral of S (S · (S_u x S_v)) / 4 over the
/// surface, by Gauss's theorem, divided by the volume. Where the normals point is of no matter.
///
/// On every piece between knots the rules of Gauss and Kronrod of 10 and 21 nodes, halved where they differ. Where
/// patches are polynomial of degree up to 4 nothing is halved and only rounding is lost.
/// @param tolerance  It is off by at most so much of half the diagonal of the box of the points, or by rounding of the
///                   coordinates where that is more, and the error says so.
/// @throws InvalidShape as volume(), and if the solid has no volume; PointAtInfinity; ToleranceNotReached.
Approximation<glm::dvec3> centroid(const PatchSet& set, double tolerance = kAreaTolerance);

/// The centroid of a surface, open or closed: that of its area, as of a thin shell. By the same rules; where a patch folds
/// back on itself they are halved again and again.
/// @param tolerance  as of centroid()
/// @throws InvalidShape if the surface has no area, or where weights differ too much; PointAtInfinity;
///         ToleranceNotReached.
Approximation<glm::dvec3> surface_centroid(const NurbsPatch& patch, double tolerance = kAreaTolerance);
Approximation<glm::dvec3> surface_centroid(const PatchSet& set, double tolerance = kAreaTolerance);

/// The second moments of the solid: the integral of d d^T, where d is the way from a point, or from the centroid if
/// there is none. Their inertia tensor at density 1 is their trace times the identity, less them. All are negative
/// where the normals point inwards, as the volume is.
///
/// They are found about the centroid, so that no digit is lost far away, and brought to the point by Steiner's theorem.
/// @param tolerance  Those about the centroid are off by at most so much of their trace, or by rounding.
/// @throws InvalidShape also if the point is not finite or a moment too large for a number; and as centroid().
Approximation<SecondMoments> second_moments(const PatchSet& set, std::optional<glm::dvec3> about = {},
                                            double tolerance = kAreaTolerance);

}  // namespace splinecore
