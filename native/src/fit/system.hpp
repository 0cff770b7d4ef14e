#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/quotient.hpp"
#include "basis/banded.hpp"
#include "conditions.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Rows of functions for the conditions, and their right sides. Rows of derivatives are divided by their largest number.
struct System {
  BandedRows rows;
  std::vector<double> right;  ///< three numbers each
};

/// @throws InvalidShape if a point has no control point of its own (Schoenberg and Whitney 1953).
System system_of(const KnotVector& knots, std::span<const Condition> conditions);

/// Writes the solution over the right side, `columns` numbers a row. @throws InvalidShape if there is none.
void solve(const KnotVector& knots, const BandedRows& rows, std::span<double> right, std::size_t columns);

/// A system that hardly decides the points leaves them to rounding.
/// @throws InvalidShape if the error is large beside the largest coordinate of a point.
void require_passing(double error, double largest);

/// @throws InvalidShape if a coordinate is not finite.
double largest_coordinate(std::span<const glm::dvec3> points);

[[noreturn]] void refuse_control_point();

/// @throws InvalidShape if a coordinate is no number any more.
inline void require_control_point(const glm::dvec3& point) {
  const bool is_surely = std::abs(point.x) + std::abs(point.y) + std::abs(point.z) < 1e300;
  if (!is_surely && !is_finite(point)) refuse_control_point();
}

}  // namespace splinecore
#pragma GCC visibility pop
