#pragma once

#include "bytes.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore::fuzz {

/// What is done to a curve, with arguments from the bytes: a verb puts its result in the curve's place.
using CurveStep = void (*)(Bytes& bytes, NurbsCurve& curve);

std::span<const CurveStep> curve_verbs();
std::span<const CurveStep> curve_measures();
/// What other forms of the curve do: Bezier, Hermite, power, conics.
std::span<const CurveStep> curve_forms();

}  // namespace splinecore::fuzz
