#pragma once

#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// How smoothly two pieces of a curve, or two curves, meet (S16).
struct Continuity {
  double gap = 0.0;                   ///< G0: distance of the two ends
  double angle = 0.0;                 ///< G1: between the directions, in [0, pi]
  double curvature_difference = 0.0;  ///< G2: length of the difference of the two curvature vectors
  int c = -1;  ///< derivatives that agree, -1 for a gap; the degree where all do: there is no joint at all
  int g = -1;  ///< -1 for a gap, 0, 1, 2, or c where that is more and the curve moves on
};

/// Relative size below which a difference is called none; of directions, the angle. What rounding makes is none, too.
inline constexpr double kContinuityTolerance = 1e-8;

/// At a parameter. Directions and curvatures are limits: where a derivative falls to zero the next ones tell.
/// A periodic curve takes any parameter, modulo its period.
/// @throws PointAtInfinity
/// @throws InvalidShape unless u lies inside the domain of a plain curve.
Continuity continuity_at(const NurbsCurve& curve, double u, double tolerance = kContinuityTolerance);

/// Between the end of a and the start of b, each with its own parameter.
Continuity continuity_between(const NurbsCurve& a, const NurbsCurve& b, double tolerance = kContinuityTolerance);

struct Joint {
  double u = 0.0;
  Continuity continuity;
};

/// Every inner knot of a curve, and the seam of a periodic one or of one whose ends meet; those at infinity
/// are left out.
std::vector<Joint> joints(const NurbsCurve& curve, double tolerance = kContinuityTolerance);

}  // namespace splinecore
