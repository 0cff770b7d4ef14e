#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"

namespace splinecore {

/// All rows of de Casteljau's triangle: degree + 1, degree, … 1 points.
using Triangle = std::vector<std::vector<glm::dvec4>>;

/// The homogeneous algorithm: rows of (wx, wy, wz, w), defined at any weights (lecture row S9). Outside [0, 1] it
/// extrapolates: the last row is the polynomial's homogeneous point there, too.
/// @throws InvalidShape if u is not finite or a point is too large for a number.
Triangle casteljau_triangle(const BezierCurve& curve, double u);

/// Where the rational algorithm would divide by zero: row 0 are the control points.
struct Breakdown {
  int row = 0;
  int index = 0;
  std::string reason;
};

/// Rows of (x, y, z, w). After a breakdown only the rows before it.
struct RationalTriangle {
  Triangle rows;
  std::optional<Breakdown> breakdown;
};

/// The rational algorithm, which divides in every step, for teaching: points stay affine
/// combinations of points, and each has its weight (Farin 1983; lecture row S9).
///
/// It breaks down at a weight that is zero, or is the rounding of two that cancel.
/// Outside [0, 1] it extrapolates.
/// @throws InvalidShape if u is not finite.
RationalTriangle rational_casteljau_triangle(const BezierCurve& curve, double u);

}  // namespace splinecore
