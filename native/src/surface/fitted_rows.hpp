#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/build/parameterization.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Homogeneous rows of control points at parameters, row after row. At the end of a stretch they are those from before it.
using RowsAt = std::function<std::vector<glm::dvec4>(std::span<const double> at, const Interval& stretch)>;

/// Where rows are less smooth than between, and how often a cubic spline has its knot there if it has one.
struct RowJoint {
  double at;
  int copies;
};

/// Of rows that depend on a curve or patch with these knots and on its first derivatives, as frames of a rail do.
std::vector<RowJoint> joints_at(const KnotVector& knots);

/// Where rows are wanted.
struct RowDomain {
  std::vector<double> breaks;    ///< from the start to the end; inside they are corners
  std::vector<RowJoint> joints;  ///< in any order
  Closing closing;               ///< closed: the last rows are the first, and the only breaks are the ends
};

/// Rows of control points along v.
struct FittedRows {
  KnotVector knots;
  std::vector<glm::dvec4> rows;  ///< homogeneous, row after row
  double error;                  ///< the largest distance of a point from where it should be that was found
};

/// Cubic splines, continuously differentiable between breaks, and twice so but at joints, whose rows come within a tolerance
/// of those given: through them at Greville's places of knots that grow where they do not. Weights that do not change stay as
/// they are.
/// @throws ToleranceNotReached if 2^14 rows do not come within it
FittedRows fitted_rows(const RowsAt& rows_at, const RowDomain& domain, double tolerance);

/// The patch whose rows along u these are.
NurbsPatch patch_of(const KnotVector& knots_u, const FittedRows& rows);

}  // namespace splinecore
#pragma GCC visibility pop
