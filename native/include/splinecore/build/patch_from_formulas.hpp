#pragma once

#include <array>
#include <span>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/formula/formula.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// Up to this degree in each direction a polynomial patch is made exact.
inline constexpr int kHighestExactPatchDegree = 64;

/// The patch x(u, v), y(u, v), z(u, v) over two domains; its parameters are u and v (lecture row S1).
///
/// Where all are polynomials, one Bezier patch, exact: the error is 0. Otherwise biquintic, with all mixed
/// derivatives up to two in each direction those of the formulas at the corners of a grid: C2. Lines of the
/// grid are added till every cell lies within the tolerance at the places where it is measured, 16384 or
/// more in all; the error is the largest distance that was found. Where a derivative does not exist 0
/// takes its place, so a crease or a pole of the parameters costs many cells, and a crease that follows no
/// line of the grid cannot be had.
/// @throws InvalidShape if there are not three formulas of two variables each, a domain is not finite or
///         has no length, the tolerance is not positive, or naming parameters where a formula is
///         undefined; ToleranceNotReached at a jump or a pole, or with more than 100,000 cells.
Approximation<NurbsPatch> patch_from_formulas(std::span<const Formula> coordinates,
                                              const std::array<Interval, 2>& domains, double tolerance);

}  // namespace splinecore
