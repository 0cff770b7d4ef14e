#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Whether a place is inside, by how often all curves of each owner together go round it.
using WindingRule = std::function<bool(std::span<const int> windings)>;

/// Closed curves in a plane, none of which meets itself.
struct OwnedLoops {
  std::vector<NurbsCurve> curves;
  std::vector<std::size_t> owners;  ///< of each; curves of one do not cross each other
  std::size_t owner_count = 0;
};

/// The border of what is inside, to the left of it: closed curves that do not meet themselves, of pieces of those given.
/// @throws InvalidShape if curves run along each other so that the tolerance does not tell on which side
std::vector<NurbsCurve> boundary_of(const OwnedLoops& loops, const WindingRule& is_inside, const glm::dvec3& normal, double tolerance);

/// What closed curves enclose that may meet themselves and each other, by how often all together go round.
struct WoundCurves {
  std::vector<NurbsCurve> loops;     ///< the border of what is inside
  std::vector<std::size_t> nothing;  ///< numbers of curves that only go to and fro
};
WoundCurves wound_by(std::span<const NurbsCurve> curves, const std::function<bool(int turns)>& is_inside, const glm::dvec3& normal,
                     double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
