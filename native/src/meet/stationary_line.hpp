#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/meet/stationary.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Homogeneous pieces, one column each, on the spans of a knot vector.
struct PieceLine {
  KnotVector knots;
  bool is_closed;  ///< whether the last one ends where the first begins
  std::vector<BernsteinNet<glm::dvec4>> pieces;
};

/// A place of a line where the distance from a point is stationary, or an end, or a corner where it is a minimum or a
/// maximum.
struct LinePlace {
  std::size_t piece;
  double t;    ///< in [0, 1]
  int before;  ///< whether the distance rises (1) or falls (-1) before the place; 0 where nothing is before
  int after;
};

/// What it is of a place before and after which a value goes so.
inline Stationary kind_of(int before, int after) noexcept {
  if (before <= 0 && after >= 0) return Stationary::minimum;
  return before >= 0 && after <= 0 ? Stationary::maximum : Stationary::saddle;
}

/// All finite places of a line, in order; a knot that the line goes on at is one, as a rule the start of a piece.
/// @param rounding  how much of a coordinate may be rounding
/// @param constant  told of pieces all of which is at one distance
std::vector<LinePlace> stationary_places(const PieceLine& line, const glm::dvec3& point, double rounding,
                                         const std::function<void(std::size_t)>& constant);

}  // namespace splinecore
#pragma GCC visibility pop
