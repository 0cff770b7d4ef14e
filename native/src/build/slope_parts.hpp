#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/curve/bezier_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of a Bezier curve (A, W) in Bernstein's forms: of A' W - A W', which over W² is its derivative, of W, and of the determinant
/// of the point and two derivatives, which times W³ over the cube of the first one's length is the curvature.
struct SlopePart {
  Interval part;
  BernsteinNet<glm::dvec3> slope;
  BernsteinNet<double> weight;
  BernsteinNet<double> bend;

  /// Between which numbers the length of the slope is.
  Interval slope_lengths() const;
};

/// The parts, in order and each of 2^-depth of [0, 1], of which it is not seen that they do not matter.
/// @param normal   what curvatures are seen against; without, they are not asked for
/// @param matters  false where bounds tell that no place of the part does
std::vector<Interval> parts_that_matter(const BezierCurve& curve, const std::optional<glm::dvec3>& normal, int depth,
                                        const std::function<bool(const SlopePart&)>& matters);

}  // namespace splinecore
#pragma GCC visibility pop
