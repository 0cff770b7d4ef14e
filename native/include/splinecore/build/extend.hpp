#pragma once

#include <span>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// How a curve continues beyond its end.
enum class Extension {
  natural,   ///< as its last span does, by the same polynomials
  arc,       ///< round its circle of curvature
  straight,  ///< along its tangent
};

/// The curve made longer at an end; it keeps its parameters, and the domain grows.
///
/// Naturally the last knots move and the points beside them follow by blossoms; others are joined with the tangent, or
/// the curvature. An arc where the curve is straight is straight. S18.
/// @throws InvalidShape if the length is not above 0, the curve is closed or has no tangent at its end, an arc would pass
///         its whole circle, or the curve runs to infinity before that length.
NurbsCurve extended(const NurbsCurve& curve, bool at_end, double length, Extension how);

/// The curve made longer at an end up to where it first meets others.
/// @throws InvalidShape if it meets none of them within four times the size of them all; and as extended().
NurbsCurve extended_to(const NurbsCurve& curve, bool at_end, std::span<const NurbsCurve> others, Extension how);

}  // namespace splinecore
