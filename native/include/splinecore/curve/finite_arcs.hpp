#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// What of the curve lies within `length` of the box of its finite control points, in each
/// coordinate, as curves with positive weights on their parts of the domain (lecture rows S10, S11).
///
/// Parameters are kept: each arc is the curve itself on a part of the domain, in order. A curve
/// whose weights have one sign lies in its box: it comes back as it is, cut only at gaps. Other
/// arcs have knots of multiplicity degree where they were subdivided, and no control point
/// farther out than twice the length, all up to rounding. Nothing within (1 - 1e-9) length is left out, except a
/// stretch on which all four homogeneous coordinates are zero up to rounding.
/// @param around  where given, the box of these points stands for that of the control points, and curves whose
///                weights have one sign are cut at its reach, too
/// @throws InvalidShape unless length is positive and finite.
std::vector<NurbsCurve> finite_arcs(const NurbsCurve& curve, double length, std::span<const glm::dvec3> around = {});

}  // namespace splinecore
