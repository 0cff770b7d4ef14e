#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/build/parametrisation.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Homogeneous rows of control points at parameters, row after row. At the end of a stretch they are those from before it.
using RowsAt = std::function<std::vector<glm::dvec4>(std::span<const double> at, const Interval& stretch)>;

/// Rows of control points along v.
struct FittedRows {
  KnotVector knots;
  std::vector<glm::dvec4> rows;  ///< homogeneous, row after row
  double error;                  ///< the largest distance of a point from where it should be that was found
};

/// Cubic splines, twice continuously differentiable between breaks, whose rows come within a tolerance of those given:
/// through them at parameters that are halved where they do not.
/// @param breaks   from the start to the end of a domain; inside they are corners
/// @param closing  closed: the last rows are the first, and the only breaks are the ends
/// @throws ToleranceNotReached if 2^14 rows do not come within it
FittedRows fitted_rows(const RowsAt& rows_at, const std::vector<double>& breaks, Closing closing, double tolerance);

/// The patch whose rows along u these are.
NurbsPatch patch_of(const KnotVector& knots_u, const FittedRows& rows);

}  // namespace splinecore
#pragma GCC visibility pop
