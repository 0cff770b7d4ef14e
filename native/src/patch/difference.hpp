#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// Bernstein coefficients of a tensor piece, row after row.
template <class Value>
struct Net {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Value> values;

  /// Those of the four corners of the piece, where it has the values itself.
  std::array<Value, 4> corners() const {
    return {values.front(), values[columns - 1], values[values.size() - columns], values.back()};
  }
};

/// The difference of two patches where both are one piece: a rational Bezier patch of its own.
///
/// Its homogeneous weight is the product of the two patches', or where these are equal the one of both.
struct DifferencePiece {
  Net<glm::dvec4> points;
  Net<glm::dvec2> weights;  ///< of both patches, the largest on the piece 1
  double limit = 0.0;       ///< points of which both weights are below it are left out
  double rounding = 0.0;    ///< of the homogeneous coordinates

  /// Whether every point of the piece is left out.
  bool is_left_out() const;

  /// The length up to which the points of the piece reach, as far as their hull tells; may be infinite.
  double bound() const;

  /// A length that the piece certainly reaches; infinite where one patch has a pole and the other has none.
  double known() const;

  /// Whether nothing but rounding is left of the difference.
  bool is_rounding() const;

  /// The quarters of the piece.
  std::array<DifferencePiece, 4> quarters() const;

  /// What halving into quarters costs, in multiplications.
  double work() const;
};

/// Where two patches on one domain differ, piece by piece; pieces that are equal bit for bit are left out.
std::vector<DifferencePiece> difference_pieces(NurbsPatch a, NurbsPatch b);

}  // namespace splinecore
