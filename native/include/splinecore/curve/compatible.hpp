#pragma once

#include <utility>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// Both curves over the domain of the first, of one degree and on one knot vector: what it takes to go from
/// one to the other (The NURBS Book, 8.4; S15).
///
/// The domain of b is mapped; a knot that then lies within a few roundings of one of a's is taken for it. The
/// lower degree is raised and the knots are merged. Periodic only if both are, otherwise clamped, unless the
/// knots are equal from the start.
/// @throws InvalidShape if the mapped knots do not stay apart.
std::pair<NurbsCurve, NurbsCurve> compatible(const NurbsCurve& a, const NurbsCurve& b);

}  // namespace splinecore
