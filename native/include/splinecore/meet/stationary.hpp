#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/meet/nearest.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// What a distance is at a place, among those beside it on the shape: a saddle is neither of the others.
enum class Stationary { minimum, maximum, saddle };

/// A place of a curve where the distance from a point is stationary.
struct StationaryOnCurve {
  double parameter;
  glm::dvec3 point;
  double distance;
  Stationary kind;
};

/// A place of a patch where the distance from a point is stationary.
struct StationaryOnPatch {
  double u;
  double v;
  glm::dvec3 point;
  double distance;
  Stationary kind;
};

/// All places of a curve where the distance from a point is stationary, (C - P) · C' = 0, its ends and those of its
/// pieces, and corners where the distance is a minimum or a maximum: in the order of parameters, each once, of a
/// curve that ends where it begins in [start, end).
///
/// Zeros of a polynomial in Bernstein's form on every span, by halving (bernstein_zeros). Places that rounding does not
/// tell apart are one. Of a curve that passes through infinity the finite places count.
/// @throws InvalidShape if the point is not finite or too far away, or naming an interval on which the distance is
///         constant; PointAtInfinity if the whole curve is.
std::vector<StationaryOnCurve> stationary_points(const NurbsCurve& curve, const glm::dvec3& point);

/// Those places of a curve that are minima of the distance and at most `tolerance` farther than its least one.
/// @param tolerance  none: a few roundings of the coordinates
/// @throws InvalidShape as above, where the constant distance is as small, or if the tolerance is below 0 or no number.
std::vector<NearestOnCurve> nearest_all(const NurbsCurve& curve, const glm::dvec3& point,
                                        std::optional<double> tolerance = {});

/// The same of a patch: places where (S - P) · S_u and (S - P) · S_v are zero, and of borders, corners, poles and edges
/// between pieces those where the distance is a minimum or a maximum of the patch; in the order of u, then v.
///
/// Common zeros of two polynomials in Bernstein's form on every pair of spans, by halving and Newton's method
/// (plane_zeros). Where two opposite borders are one there is no border.
/// @throws InvalidShape as above, or naming a place near which they are a curve or more, as from the center of a
///         sphere, or where they cannot be told apart.
std::vector<StationaryOnPatch> stationary_points(const NurbsPatch& patch, const glm::dvec3& point);

std::vector<NearestOnPatch> nearest_all(const NurbsPatch& patch, const glm::dvec3& point,
                                        std::optional<double> tolerance = {});

}  // namespace splinecore
