#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Knots under t = rho u / ((1 - u) + rho u), u and t in [0, 1] over the domain, which stays; and what each
/// homogeneous control point is multiplied by (Lee and Lucian 1991; The NURBS Book, 6.4; lecture row S12).
struct MoebiusKnots {
  std::vector<double> knots;  ///< not yet a vector: rounding may have brought too many together
  std::vector<double> factors;
};

/// @throws InvalidShape unless rho > 0 and the vector is plain; see has_moebius_pole().
MoebiusKnots moebius(const KnotVector& knots, double rho);

/// Whether the map has its pole, which lies outside the domain, at a knot or between the knots: then there is
/// no such map of the knots unless they are clamped first.
/// @throws InvalidShape unless rho > 0.
bool has_moebius_pole(const KnotVector& knots, double rho);

/// The given point whose homogeneous point is multiplied by a factor.
/// @param index, row_length  its place, for the message
/// @throws InvalidShape if the weight leaves the range of numbers.
glm::dvec4 multiplied(const glm::dvec4& given, double factor, std::size_t index, std::size_t row_length = 0);

}  // namespace splinecore
#pragma GCC visibility pop
