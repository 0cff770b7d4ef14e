#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/build/parameterization.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Rows of numbers, as many in each, that a spline has at parameters, and derivatives 1, 2, … at its ends.
struct RowConditions {
  std::vector<double> parameters;  ///< one for each row, and where closed one more for the return
  std::vector<std::vector<double>> rows;
  std::vector<std::vector<double>> start;
  std::vector<std::vector<double>> end;
};

/// A homogeneous row as numbers.
std::vector<double> numbers_of(std::span<const glm::dvec4> row);

/// Rows of numbers as control points.
struct RowSpline {
  KnotVector knots;
  std::vector<double> controls;  ///< row after row
};

/// The spline through rows, as interpolate() has it of points, all columns at once.
/// @param knots  all of them, one period where closed; empty: averaged
/// @throws InvalidShape as interpolate()
RowSpline spline_through(const RowConditions& given, int degree, Closing closing, const std::vector<double>& knots = {});

/// Its knots alone.
KnotVector knots_through(const RowConditions& given, int degree, Closing closing, const std::vector<double>& knots = {});

/// Rows of numbers at parameters, one for each control point, become the control points of the spline on these knots through
/// them. @throws InvalidShape as interpolate()
void solve_rows(const KnotVector& knots, std::span<const double> parameters, std::span<double> rows);

}  // namespace splinecore
#pragma GCC visibility pop
