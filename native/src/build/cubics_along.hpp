#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "meet/near_space.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A parameter of a path, and another one on the side from which it is looked at.
struct PathParameter {
  double at;
  double towards;
};

/// A place of a path and its derivative.
struct PathPlace {
  glm::dvec3 point;
  glm::dvec3 slope;
};

/// A curve, about 1 large, given by its places, of which many are asked for at once.
using Path = std::function<std::vector<PathPlace>(const std::vector<PathParameter>&)>;

/// How far cubics may be from a path, in the space of its shape: 2^-20 of its size where that is not given.
/// @param size  of the path in that space
double cubics_tolerance(const NearSpace& space, std::optional<double> tolerance, double size = 1.0);

/// In order, each place once, from the start to the end of a domain.
std::vector<double> distinct_breaks(std::vector<double> breaks, const Interval& domain);

/// A path as cubics with its tangents, halved until they are within half the tolerance at 13 places of each.
/// @param breaks  from its start to its end: where it may have corners, which have triple knots, or gaps: one more;
///                other joints have double ones
/// @throws InvalidShape if it does not come within the tolerance in 2^20 cubics.
NurbsCurve cubics_along(const Path& path, const std::vector<double>& breaks, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
