#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/bernstein_net.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The difference of two rational pieces on the same parameters: a rational piece of its own.
///
/// Its homogeneous weight is the product of the two pieces' weights, or where these are equal the one of both.
struct DifferencePiece {
  BernsteinNet<glm::dvec4> points;
  BernsteinNet<glm::dvec2> weights;  ///< of both pieces, the largest 1
  double limit = 0.0;       ///< points of which both weights are below it are left out
  double rounding = 0.0;    ///< of the homogeneous coordinates

  /// Whether every point of the piece is left out.
  bool is_left_out() const;

  /// The length up to which the points of the piece reach, as far as their hull tells; may be infinite.
  double bound() const;

  /// A length that the piece certainly reaches; infinite where one of the two has a pole and the other has none.
  double known() const;

  /// Whether nothing but rounding is left of the difference.
  bool is_rounding() const;

  /// The piece halved along every direction that has more than one coefficient.
  std::vector<DifferencePiece> parts() const;

  /// What halving it costs, in multiplications.
  double work() const;
};

/// Where the weights of both may be zero, points are left out of which each weight is below a sixteenth of the
/// largest on its piece: there both run off, and rounding decides how far apart.
/// @param a,b  homogeneous points of both pieces, of equal size
DifferencePiece difference(BernsteinNet<glm::dvec4> a, BernsteinNet<glm::dvec4> b);

/// The largest length of any point of the pieces: an upper bound, at most `slack` times the truth unless that is
/// below rounding.
///
/// By the hull of ever smaller parts. A search that would take longer than a second ends before, with a bound that
/// may be wide.
double largest_length(std::vector<DifferencePiece> pieces, double slack);

}  // namespace splinecore
#pragma GCC visibility pop
