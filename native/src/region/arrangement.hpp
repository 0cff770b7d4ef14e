#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of a closed curve between two places where it meets others, or all of it: clamped, with ends that are vertices in every
/// bit and have the weight 1.
struct ArrangedEdge {
  NurbsCurve curve;
  std::size_t from;  ///< vertices
  std::size_t to;
};

/// Closed curves cut where they meet.
struct Arrangement {
  std::vector<glm::dvec3> vertices;
  std::vector<ArrangedEdge> edges;
  std::vector<std::vector<std::size_t>> outlines;  ///< the edges of each curve, in order
};

/// @param owners  of each curve: those that have the same one are known not to cross, and are not cut with each other
Arrangement arranged(std::span<const NurbsCurve> curves, std::span<const std::size_t> owners, double tolerance);

/// A closed curve cut where it meets itself.
Arrangement arranged_with_itself(const NurbsCurve& curve, double tolerance);

/// Places of a curve, evenly spread over its domain, without its ends.
std::vector<glm::dvec3> places_along(const NurbsCurve& curve, int count);

/// One vertex takes in what is so many tolerances around.
inline constexpr double kVertex = 4.0;

}  // namespace splinecore
#pragma GCC visibility pop
