#pragma once

#include <optional>

#include "near_points.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The control points of a cubic whose points between two rows at each end lie at its knots, by elimination in a
/// tridiagonal matrix (de Boor 1978, ch. IV).
/// @param system  another point stands behind its points
/// @returns nothing where it is no such system, or numbers run out of their range
std::optional<NearSolution> solve_at_knots(const NearPoints& system);

}  // namespace splinecore
#pragma GCC visibility pop
