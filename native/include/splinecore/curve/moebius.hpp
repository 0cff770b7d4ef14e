#pragma once

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The same curve under the parameter t = rho u / ((1 - u) + rho u), u and t in [0, 1]:
/// weight i is multiplied by rho^i, and so are the coordinates of a direction (lecture row S12).
/// @throws InvalidShape unless rho > 0, or if a weight would leave the range of numbers. A negative
///         rho would trace the rest of the projective line, another curve on the same conic.
BezierCurve moebius(const BezierCurve& curve, double rho);

/// The same over the whole domain of a NURBS curve, which stays: knots move, points stay, and each
/// weight is multiplied by the map's factors at its knots (Lee and Lucian 1991; The NURBS Book, 6.4).
///
/// The map has a pole outside the domain. A curve with a knot beyond it is clamped first. A periodic
/// curve comes out as a plain closed one: the map does not repeat itself from one period to the next.
NurbsCurve moebius(const NurbsCurve& curve, double rho);

/// The same curve with the weight 1 at both ends (Patterson 1985; lecture row S12).
/// @throws InvalidShape unless the end weights have one sign, not 0; for a NURBS curve also unless
///         both ends are clamped.
BezierCurve standard_form(const BezierCurve& curve);
NurbsCurve standard_form(const NurbsCurve& curve);

}  // namespace splinecore
