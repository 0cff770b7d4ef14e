#pragma once

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The same curve in one degree more: all four homogeneous coordinates times the linear function that is `start` at the start
/// of the domain and `end` at its end. Places and parameters stay, weights change (lecture row S9).
///
/// A periodic curve becomes a plain closed one, for the function does not repeat itself.
/// @throws InvalidShape unless both numbers lie from 1e-100 to 1e100, if a weight would leave the range of numbers, and if the degree
///         would exceed kMaxDegree.
NurbsCurve multiplied(const NurbsCurve& curve, double start, double end);
BezierCurve multiplied(const BezierCurve& curve, double start, double end);

}  // namespace splinecore
