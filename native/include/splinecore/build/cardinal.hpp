#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/build/parameterization.hpp"
#include "splinecore/curve/hermite_curve.hpp"

namespace splinecore {

/// The tangent at an end of an open chain, which has one neighbor only.
enum class EndTangent {
  parabola,  ///< of the parabola through the last three points
  chord,     ///< along the last chord
  natural,   ///< so that the second derivative vanishes
};

/// How tangents come from the neighbors of a point (Kochanek and Bartels 1984; lecture row S5).
struct Shaping {
  double tension = 0.0;     ///< 1: the tangents vanish; below 0 they grow
  double continuity = 0.0;  ///< other than 0: a corner
  double bias = 0.0;        ///< 1: along the chord before the point; -1: along the one after it
};

/// A Kochanek-Bartels spline through the points; Catmull-Rom's where all numbers are 0.
///
/// With chords d_i = (P_{i+1} - P_i) / h_i and s = h_{i-1} + h_i the tangents at P_i are
///   incoming (1-t) ((1-c)(1+b) h_i d_{i-1} + (1+c)(1-b) h_{i-1} d_i) / s,
///   outgoing (1-t) ((1+c)(1+b) h_i d_{i-1} + (1-c)(1-b) h_{i-1} d_i) / s,
/// which on uniform parameters are those of the lectures, and for t = c = b = 0 the slope of the parabola
/// through three points on any. At an open end the chosen one-sided tangent, times 1 - t; natural is not
/// scaled, or it would not be natural. A closed chain has the first point once more as its last.
///
/// @param shaping     one for all points, or one for each
/// @param parameters  one for each point, and where closed one more for the return
/// @throws InvalidShape if there are fewer than 2 points (3 where closed), counts disagree, a number is not
///         finite or the parameters do not increase.
HermiteCurve kochanek_bartels(std::span<const glm::dvec3> points, std::span<const Shaping> shaping,
                              std::vector<double> parameters, Closing closing = Closing::open,
                              EndTangent ends = EndTangent::parabola);

}  // namespace splinecore
