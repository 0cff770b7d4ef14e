#pragma once

#include <cstddef>
#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Even knots, clamped, and as many parameters as they have control points.
struct ChebyshevSites {
  std::vector<double> knots;
  std::vector<double> parameters;
};

/// From 0 to a length: the places where the spline on these knots that swings evenly between 1 and -1 is at its tops (Demko
/// 1985; Mørken 1996). Through values there goes a spline that is at most three times as large, of all degrees and counts.
/// @param count  degree + 1 at least
ChebyshevSites chebyshev_sites(int degree, std::size_t count, double length);

}  // namespace splinecore
#pragma GCC visibility pop
