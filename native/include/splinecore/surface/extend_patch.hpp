#pragma once

#include "splinecore/build/extend.hpp"
#include "splinecore/patch/isocurve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// The patch made longer at a side by a length, the mean of 64 or more lines along it; it keeps its parameters, and the domain grows.
///
/// Naturally each line continues by the polynomials of its last span (blossoms, row S20), straight along its tangent, once
/// continuously differentiable. Arcs are for curves.
/// @throws InvalidShape if the length is not above 0, or not within 2^40 times the size of the patch, the direction is periodic, lines have no tangent at the side or run to
///         infinity before that length, or an arc is asked for.
NurbsPatch extended(const NurbsPatch& patch, Border side, double length, Extension how = Extension::natural);

}  // namespace splinecore
