#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/fit/interpolate_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// What a patch near a grid of points is in one of its directions.
struct NearDirection {
  std::vector<double> parameters;  ///< one for each row of points, and where closed one more for the return
  int degree = 3;
  Closing closing = Closing::open;
  std::size_t count = 4;          ///< of control points: with as many points between each two knots
  std::vector<double> knots;      ///< all of them, one period where closed; empty: by count
  double smoothing = 0.0;         ///< as of curves, for the lines of this direction
  std::vector<double> weights;    ///< positive, one for each row of points; empty: 1 each
};

/// The polynomial spline patch that is nearest to a grid of points in the sum of squares, first along u, then along v
/// (The NURBS Book, §9.4.3, A9.7; lecture row S20): linear in the number of points.
/// The square of a point's distance weighs the product of its rows' weights along u and along v: with others the directions
/// cannot be solved one after the other, and the points are scattered ones.
/// @param fixed_ends  in open directions its border is nearest to the outermost lines of the grid, and its corners are
///                    theirs
/// @returns the patch, and the largest distance of a point from the patch's point at its parameters
/// @throws InvalidShape naming the direction, as approximate() does of curves.
Approximation<NurbsPatch> approximate(const PointGrid& grid, const NearDirection& u, const NearDirection& v,
                                      bool fixed_ends = true);

/// The same with as few control points in each direction as come within the tolerance; count is the most. A patch that
/// leaves its points in between, by more than the size of a place's neighborhood, `degree` points on each side, is not
/// taken. Where a direction has no parameters they are chordal, or calm_parameters() where patches would swing at those.
/// @throws ToleranceNotReached if they do not; InvalidShape unless it is positive.
Approximation<NurbsPatch> approximate_within(const PointGrid& grid, NearDirection u, NearDirection v, double tolerance,
                                             bool fixed_ends = true);

struct ScatteredOptions {
  std::vector<double> weights;  ///< of the squared distances, positive, one for each point; empty: 1 each
  double smoothing = 0.0;       ///< weight of the thin plate's energy beside the mean of the squares
  int corrections = 8;          ///< so often at most parameters move to the nearest points, while that helps
};

/// Where points lie in the plane that is nearest to them: in the rectangle of least area, whose longer side is u, from 0
/// to 1; along v in the same proportion. The plane's upper side is that of z, or of the first axis that tells.
/// @throws InvalidShape if the points lie on a line.
std::vector<glm::dvec2> plane_parameters(std::span<const glm::dvec3> points);

/// The polynomial spline patch near scattered points: least squares at their parameters, which move to the nearest
/// points of the patch (Hoschek 1988; Ma and Kruth 1995), with the energy of a thin plate where that is wanted. Linear in
/// the number of points; in that of control points their number times the square of the lesser of both counts.
/// @param parameters  one for each point, in the domain
/// @returns the patch, and the largest distance of a point from it
/// @throws InvalidShape if the directions are periodic, or the points do not determine the patch: not at all, or so little
/// that control points would lie a million times as far away, or the patch leaves the box around them by more than four
/// times its size.
Approximation<NurbsPatch> approximate(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                      const KnotVector& u, const KnotVector& v, const ScatteredOptions& options = {});

/// How many control points a patch near scattered points has, on even knots.
struct NetSize {
  int degree_u = 3;
  int degree_v = 3;
  std::size_t count_u = 4;
  std::size_t count_v = 4;
};

/// The same on even knots around the parameters; those of plane_parameters() where none are given.
Approximation<NurbsPatch> approximate(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                      const NetSize& size, const ScatteredOptions& options = {});

/// The same with few control points within a tolerance; size has the most. Where the points do not decide alone, or the
/// patch would leave the box around them by more than its size, the energy of a thin plate decides, as much of it as the
/// tolerance leaves room for, of nets that have no more control points than there are points.
/// @throws ToleranceNotReached if they do not come within the tolerance; InvalidShape unless it is positive.
Approximation<NurbsPatch> approximate_within(std::span<const glm::dvec3> points, std::span<const glm::dvec2> parameters,
                                             const NetSize& size, double tolerance,
                                             const ScatteredOptions& options = {});

}  // namespace splinecore
