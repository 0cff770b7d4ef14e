#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/patch/join.hpp"

namespace splinecore {

/// A curve as it leaves a joint, as if its parameter grew that way.
struct JointSide {
  std::vector<glm::dvec4> points;  ///< (x, y, z, weight) of the first two or three; of directions the weight is 0
  int degree;
  double first_span;               ///< from the joint to the first knot beyond it
  double second_span;              ///< from the joint to the second knot beyond it; the first again where there is none
  std::vector<bool> moved = {};    ///< points that were moved by hand; empty: none
};

struct JointPoints {
  std::vector<glm::dvec4> first;
  std::vector<glm::dvec4> second;
};

/// The control points beside a joint of two curves, or at a knot, so that one continues the other smoothly (rows S18, S21).
///
/// A clamped curve leaves by derivatives that its first three homogeneous points have (The NURBS Book, formulas 3.9 and 4.8).
/// Weights stay, and so do, to the last digit, points that need not move. Both sides begin where the one begins that stays, or
/// halfway between; where only one was moved by hand, they begin there. As many points behind it as the continuity has
/// derivatives go along with the joint, but for those that were moved by hand. Then
///   c1, c2: the sides that give way take the derivatives of the other, or both the mean;
///   g1, g2: tangent and curvature vector, each with the speed that it has, and how that changes. A side that leaves in no
///           direction has none to share: nothing else moves.
/// @param moves  which side gives way
/// @throws InvalidShape if the joint lies at infinity, points are too few or too many, a side that gives way has too low a
///         degree, spans do not increase from 0, or a point would leave the range of numbers.
JointPoints joint_points(const JointSide& first, const JointSide& second, PatchSmoothness smoothness,
                         JoinMoves moves = JoinMoves::second);

}  // namespace splinecore
