#pragma once

#include <glm/vec3.hpp>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace splinecore {

/// To which part of the largest coordinate the box of a patch is found unless asked otherwise.
inline constexpr double kBoxTolerance = 1e-12;

/// The smallest box along the axes that something lies in.
struct Box {
  glm::dvec3 low;
  glm::dvec3 high;
  friend bool operator==(const Box&, const Box&) = default;
};

/// The box of a curve, not of its control points: right to a few roundings of the largest coordinate. Weights may have
/// any signs.
///
/// Ends of spans, and the roots of the derivative along each axis on those that may lie outside.
/// @throws PointAtInfinity if the curve runs to infinity.
Box bounding_box(const NurbsCurve& curve);

/// The box of a patch.
///
/// Branch and bound: pieces are halved as long as the hull of their control points goes farther than the tolerance
/// beyond what was found. Of a piece that rises or falls along a direction everywhere only a border counts, which is
/// solved as a curve.
/// @param tolerance  relative to the largest coordinate: the box is too small by at most so much, and too large by no
///                   more than a few roundings
/// @throws InvalidShape if the tolerance is not positive; PointAtInfinity if the patch runs to infinity;
///         ToleranceNotReached if that takes more than 200 000 pieces for one side.
Box bounding_box(const NurbsPatch& patch, double tolerance = kBoxTolerance);

/// The box of all patches.
Box bounding_box(const PatchSet& set, double tolerance = kBoxTolerance);

}  // namespace splinecore
