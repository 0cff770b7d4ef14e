#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "splinecore/patch/join.hpp"

namespace splinecore {

/// The first three rows of control points of a curve or a patch, from an edge on, as if its parameter grew that way.
struct EdgeStrip {
  std::array<std::vector<glm::dvec4>, 3> rows;  ///< (x, y, z, weight), one point of each for every column; of a line any third one
  int degree;                                   ///< across the edge
  double first_span;                            ///< from the edge to the first knot beyond it
  double second_span;                           ///< from the edge to the second knot beyond it; the first again where there is none
};

/// The factors of six points of a column: three of the first strip, then three of the second one.
using ColumnFactors = std::array<double, 6>;

/// What continuity across an edge asks of where the points beside it lie, while their weights stay: in each column the sum of
/// factors times what the points move by is to be 0, once for each derivative.
///
/// With A and B for homogeneous points and t across, from the first side into the second: at the edge B = w A, B_t = k A_t + g A, and
/// B_tt = k^2 / w A_tt + m A_t + e A; of C1 and C2 k and w are 1 and m is 2 g k (Farin 2002; rows S18, S21). The numbers w, k, g, m
/// and e are read by least squares from strips of which it holds.
/// @returns for each derivative one for each column; nothing where it does not hold up to 1e-6 of the terms (of C1 and C2 also where
///          weights at the edge differ), or the edge has points at infinity
/// @throws InvalidShape if strips have different numbers of columns or none, a point is not finite, a degree is below 1, or spans
///         do not increase from 0
std::optional<std::vector<std::vector<ColumnFactors>>> joint_equations(const EdgeStrip& first, const EdgeStrip& second,
                                                                       PatchSmoothness smoothness);

}  // namespace splinecore
