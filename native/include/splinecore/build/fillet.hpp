#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// An arc that touches two curves.
struct Fillet {
  NurbsCurve arc;     ///< from the first curve to the second one, no longer than half a turn
  double a;           ///< the parameters at which it touches them
  double b;
  glm::dvec3 center;
  bool goes_on_a;     ///< whether the first curve, at `a`, runs into the arc, rather than away from it
  bool goes_on_b;     ///< whether the arc, at its end, runs along the second curve, rather than against it
};

/// All arcs of circles with a radius that touch two curves of one plane, in the order of the first curve's parameters:
/// their centers are where the curves' offsets cross, to either side, or the ends of stretches along which these are one. Where
/// Newton's method finds none, or offsets nearly touch, bounds of the offsets decide. S18.
/// @throws InvalidShape if the radius is not above 0, the normal is zero, the curves are not in a plane with it, or bounds of offsets
///         that run beside each other do not tell within 2^14 pairs of parts.
std::vector<Fillet> fillets(const NurbsCurve& a, const NurbsCurve& b, double radius, const glm::dvec3& normal);

}  // namespace splinecore
