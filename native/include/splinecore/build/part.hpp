#pragma once

#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The part of a curve between two parameters, over that part of its domain. Of a closed one the end may be up to a turn
/// behind the start: over the seam.
/// @throws InvalidShape unless start < end, both in the domain but for that; and as split().
NurbsCurve part(const NurbsCurve& curve, double start, double end);

/// The parts that a curve is cut into at parameters, in their order. Those at the ends of an open one, and those that are
/// one up to rounding, cut nothing. Of a closed curve the last part goes over the seam, which is no cut.
/// @throws InvalidShape for a parameter outside the domain.
std::vector<NurbsCurve> parts(const NurbsCurve& curve, std::vector<double> parameters);

/// Where a curve meets others, at the ends of stretches in common too, in order. S18.
/// @throws as intersections()
std::vector<double> meeting_parameters(const NurbsCurve& curve, std::span<const NurbsCurve> others);

/// The rest of a curve without the part about a parameter, between where it meets others, or its own end.
/// @throws InvalidShape if they do not meet, a closed curve meets them in one place alone, or nothing is left.
std::vector<NurbsCurve> trimmed(const NurbsCurve& curve, std::span<const NurbsCurve> others, double at);

}  // namespace splinecore
