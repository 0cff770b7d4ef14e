#pragma once

#include <vector>

namespace splinecore {

// Square matrices of lecture rows S4, S6 and S13, of degree + 1 rows, one row after the other. Every number
// is a quotient of two integers that a double holds, so it is right in the last digit.

/// For [t^degree … t 1] from the left, or the points that it makes, and control points from the right.
struct BasisMatrix {
  int degree;
  std::vector<double> values;
};

/// Highest degree at which the integers fit 53 bits.
inline constexpr int kMaxUniformDegree = 18;
inline constexpr int kMaxBezierMatrixDegree = 33;

/// B-spline segments with knots one apart (S13): for degree 3 [-1 3 -3 1; 3 -6 3 0; -3 0 3 0; 1 4 1 0] / 6.
/// @throws InvalidShape unless 0 <= degree <= kMaxUniformDegree.
BasisMatrix uniform_matrix(int degree);

/// Bezier points of such a segment from its control points: for degree 3
/// [1 4 1 0; 0 4 2 0; 0 2 4 0; 0 1 4 1] / 6. @throws InvalidShape as uniform_matrix().
BasisMatrix uniform_to_bezier(int degree);

/// Bernstein polynomials (S6): for degree 3 [-1 3 -3 1; 3 -6 3 0; -3 3 0 0; 1 0 0 0].
/// @throws InvalidShape unless 0 <= degree <= kMaxBezierMatrixDegree.
BasisMatrix bezier_matrix(int degree);

/// Hermite's cubics, for (P_1, R_1, P_4, R_4) (S4): [2 1 -2 1; -3 -2 3 -1; 0 1 0 0; 1 0 0 0].
BasisMatrix hermite_matrix();

}  // namespace splinecore
