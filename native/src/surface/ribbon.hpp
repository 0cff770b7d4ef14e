#pragma once

#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/isocurve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a patch is along a side: the rows of control points of the strip from there to the first knot across. Row 0 lies
/// along the side.
struct Ribbon {
  std::vector<NurbsCurve> rows;
  double width;  ///< of the strip, in the parameter across
};

/// @throws InvalidShape if a row lies at infinity altogether, or the side is the seam of a periodic direction.
Ribbon ribbon_of(const NurbsPatch& patch, Border side);

/// Derivative `order` out of the patch, homogeneous, for each control point along its side. The rows of the ribbon may have
/// been brought onto other knots, all onto the same. Zero above the patch's degree across.
std::vector<glm::dvec4> derivative_out(const Ribbon& ribbon, int order);

}  // namespace splinecore
#pragma GCC visibility pop
