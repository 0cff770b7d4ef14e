#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/measure/continuity.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

/// How smoothly one patch continues another across a side of each (S16).
///
/// The single numbers are the largest along the seam that are found at its places, no bounds: where the derivative along a side is almost zero, or
/// knots nearly coincide, gap and angle between places are larger by up to 2 % of that, and curvatures more. A quantity at one place is NaN where it does not exist:
/// all of it at infinity, angle and curvature where the surface has no normal, curvature also where the side stands
/// still or the surface has none, as at the tip of a cone. Such places count for nothing.
struct SeamContinuity {
  double gap = 0.0;                    ///< distance of the points
  double angle = 0.0;                  ///< between the tangent planes, in [0, pi]; pi where one folds back on the other
  double curvature_difference = 0.0;   ///< of the normal curvatures at right angles to the seam
  double first_difference = 0.0;       ///< of the derivatives across, relative to the largest of them
  double second_difference = 0.0;      ///< the same of the second derivatives
  int c = -1;                          ///< -1 for a gap, otherwise derivatives across that agree: 0, 1 or 2
  int g = -1;                          ///< -1 for a gap, 0, 1 for tangent planes, 2 for curvatures that agree
  bool reversed = false;               ///< b runs against a along the seam
  std::vector<double> parameters;      ///< places, as parts of the way along a's side
  std::vector<glm::dvec3> points;      ///< of a there
  std::vector<double> gaps;
  std::vector<double> angles;
  std::vector<double> curvature_differences;
};

/// Measured at places that lie close in every span of either side, its ends included, and on both sides of knots, and closer
/// where gap, angle or difference of curvatures are largest; or at the places given, in [0, 1].
///
/// Places of a and b are those equally far along their parameters, of closed sides from where b passes the beginning of a.
/// Normals are those of the way from a to b and of a's side, whichever way the parameters run, so that the angle is 0 where b continues a. Patches with a common side
/// and tangent planes are as curved in every direction if they are at right angles to the side (Pegna and Wolter,
/// 1992), so one number decides g = 2. The ends have no gap if they lie apart by no more than rounding does; other
/// differences are none as in continuity_between(), and curvatures below the tolerance divided by the patches' size.
/// @param reversed  b runs against a along the seam; without it run_against() says
/// @throws InvalidShape if a side lies at infinity or is the seam of a periodic direction, for places outside [0, 1]
///         or a tolerance below 0.
SeamContinuity seam_continuity(const NurbsPatch& a, Border side_a, const NurbsPatch& b, Border side_b,
                               double tolerance = kContinuityTolerance,
                               std::optional<std::span<const double>> places = {},
                               std::optional<bool> reversed = {});

}  // namespace splinecore
