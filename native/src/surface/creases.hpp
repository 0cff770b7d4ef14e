#pragma once

#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Even places in every span.
std::vector<double> places_in_spans(const KnotVector& knots, int count = 5);

/// @throws InvalidShape if the patch has a crease across a direction, at a knot or at the seam of it
void require_smooth(const NurbsPatch& patch, Axis axis);

}  // namespace splinecore
#pragma GCC visibility pop
