#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <span>

#include "basis/bernstein_net.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Between which numbers something is; none yet.
inline constexpr Interval kNothing{HUGE_VAL, -HUGE_VAL};

/// Makes room for a number.
inline void take(Interval& range, double value) {
  if (value < range.start) range.start = value;
  if (value > range.end) range.end = value;
}

/// Between which numbers A / W lies, by the hull property; from -inf to inf where weights have not one sign.
/// @param points  Bernstein's (A, W)
Interval hull_of(std::span<const glm::dvec2> points);

/// Widens the range until A / W lies in it on all of [0, 1].
/// @param line  Bernstein's (A, W), of which W is zero nowhere
void take_line(Interval& range, std::span<const glm::dvec2> line);

/// Widens the range until its end is no farther than `slack` below all of A / W.
/// @param net  of (A, W), of which W is zero nowhere
/// @returns by how much it may be too small: more than the slack where less takes too many pieces
double take_upper(Interval& range, BernsteinNet<glm::dvec2> net, double slack);

}  // namespace splinecore
#pragma GCC visibility pop
