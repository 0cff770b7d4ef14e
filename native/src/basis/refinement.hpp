#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "point_matrix.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The same functions on knots with more of them.
///
/// @param inserted  parameters of the domain, in any order, repeated for more multiplicity
/// @throws InvalidShape if one lies outside the domain or its multiplicity would exceed degree + 1.
PointMatrix refinement(const KnotVector& knots, std::span<const double> inserted);

/// What refinement() makes of points on a plain vector, without its matrix.
struct RefinedPoints {
  KnotVector knots;
  std::vector<glm::dvec4> points;
  std::vector<int> copied;  ///< if wanted, of each point: which old one it is, or -1
};
RefinedPoints refined(const KnotVector& knots, std::span<const glm::dvec4> points, std::span<const double> inserted,
                      bool with_copies);

/// `times` copies of u.
/// @throws InvalidShape unless 1 <= times <= degree + 1.
std::vector<double> knot_copies(const KnotVector& knots, double u, int times);

/// The knots inside the domain that a vector on the same domain has and this one lacks, each as often as it lacks it.
std::vector<double> missing_inside(const KnotVector& knots, const KnotVector& other);

}  // namespace splinecore
#pragma GCC visibility pop
