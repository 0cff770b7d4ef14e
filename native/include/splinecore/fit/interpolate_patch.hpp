#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/axis.hpp"
#include "splinecore/fit/interpolate.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// Points row after row: (i, j) is points[i * count_v + j], with i along u.
struct PointGrid {
  std::span<const glm::dvec3> points;
  std::size_t count_u;
  std::size_t count_v;

  std::size_t count(Axis axis) const noexcept { return axis == Axis::u ? count_u : count_v; }
};

/// What an interpolating patch is in one of its directions, as interpolate() has it of curves.
struct FitDirection {
  std::vector<double> parameters;  ///< one for each row of points, and where closed one more for the return
  int degree = 3;
  Closing closing = Closing::open;
  FitEnds ends = FitEnds::averaged;
  std::vector<double> knots;  ///< all of them, one period where closed; empty: chosen
};

/// Parameters 0, … along one direction of a grid: each of its lines has its own from 0 to 1, their means are taken, and
/// a line that is one point has no say (The NURBS Book, A9.3). They end at the mean length of the lines.
/// @throws InvalidShape if a coordinate is not finite, all lines are points, or a step is zero in all of them.
std::vector<double> parameters_of(const PointGrid& grid, Axis axis, Parameterization kind,
                                  Closing closing = Closing::open);

/// As calm_parameters() of curves: between two rows by the points of them that lie farthest apart, so that no line sets
/// higher derivatives than it has room for, and with twice as many roots, for where rows crowd in both directions their
/// points' distances serve both. They end at the mean length of the lines that are no points.
/// @throws InvalidShape as parameters_of(); only equal steps take two rows in one place.
std::vector<double> calm_parameters(const PointGrid& grid, Axis axis, int degree, Closing closing = Closing::open);

/// The polynomial spline patch through all points (The NURBS Book, §9.2.5; lecture row S20): linear in their number.
///
/// One banded system a direction, for all lines at once.
/// @returns the patch, and the largest distance from a point that rounding left
/// @throws InvalidShape as interpolate() does, naming the direction; or if the grid has another number of points, or one of
///         its coordinates is not finite.
Approximation<NurbsPatch> interpolate(const PointGrid& grid, const FitDirection& u, const FitDirection& v);

/// The same at calm_parameters() in directions without parameters. Where these have no knots and no other ends either, the
/// patch stays near its points, as curves do: within three of the longest sides beside a cell. What swings wider gets even
/// parameters and knots there, those of open directions at the tops of their Chebyshev spline.
/// @throws InvalidShape as both do
Approximation<NurbsPatch> interpolate_calmly(const PointGrid& grid, FitDirection u, FitDirection v);

}  // namespace splinecore
