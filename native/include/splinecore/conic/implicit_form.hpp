#pragma once

#include <vector>

#include "splinecore/conic/implicit_conic.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The equation of a quadratic rational curve, by products of its points alone: with the lines
/// L_0, L_1, L_2 through pairs of homogeneous points it is L_1² = 4 L_0 L_2 (Farin 1997, ch. 12; row S1).
///
/// The plane is xy where every z is 0, otherwise one with its origin in the first finite control
/// point and x along the polygon. The largest quadratic coefficient is 1.
/// @throws InvalidShape unless the degree is 2, or if the points lie on one line.
ImplicitConic implicit_conic(const BezierCurve& curve);

/// The conic on which a curve of any degree lies, if there is one: through five of its points, where as many points of each
/// span as decide it (Bezout: two for each degree, and one) lie on it, too, up to rounding.
/// @throws InvalidShape if the curve lies on no conic, or on a line.
ImplicitConic implicit_conic(const NurbsCurve& curve);

/// The real points of a conic as curves that cover them, each once.
///
/// An ellipse is one closed curve of four spans. A parabola is one curve of two spans, each branch of
/// a hyperbola one of one span, each line one of degree 1; these begin and end at infinity
/// in directions (points of weight 0): finite_arcs() clips them. Nothing for a point or an empty conic.
std::vector<NurbsCurve> curves_of(const ImplicitConic& conic);

}  // namespace splinecore
