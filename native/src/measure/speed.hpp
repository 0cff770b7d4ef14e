#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "kernels/kernels.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The length of a piece, how far it is from that by a rule with half as many nodes, and the integral of the size of the
/// terms that it is made of, to which its rounding is relative.
struct PieceLength {
  double value = 0.0;
  double error = 0.0;
  double terms = 0.0;
};

/// The speed |N| / W² of a homogeneous curve (A, W) over [0, 1], N = A' W - A W', both in Bernstein's form. The fourth
/// number of N is the size of the terms of the others.
struct SpeedPiece {
  BernsteinNet<glm::dvec4> slopes;
  BernsteinNet<double> weights;  ///< of degree 0 if W is 1

  /// The part before t stays, `after` takes the other one, in the memory that it has; each is over [0, 1] again.
  void cut(double t, SpeedPiece& after);

  /// Whether N is zero at the ends at most, or is nothing but rounding. Between a cusp and the nearest node of a rule the
  /// rule sees nothing of it; here Bernstein coefficients on one side of a plane leave no room for a zero.
  bool is_regular() const;

  /// Whether the weights have one sign and are so alike that no narrow peak lies between nodes.
  bool is_even() const;

  /// Brings weights that are all large or small near 1: squares of N would leave the range of numbers.
  void normalize();
};

/// Speeds of curves of one degree.
class Speed {
 public:
  Speed(int degree, bool is_rational);

  /// Writes the speed of a Bezier piece of degree + 1 points.
  void write(std::span<const glm::dvec4> points, SpeedPiece& out);

  /// By Gauss's and Kronrod's rule of 15 and 31 nodes (Kronrod 1965; QUADPACK's QK31).
  PieceLength length(const SpeedPiece& piece) const;

 private:
  PieceLength length(const BernsteinNet<glm::dvec4>& slopes, const BernsteinNet<double>& weights) const;
  void write_rational(std::span<const glm::dvec4> points, SpeedPiece& out) const;
  void write_plain(std::span<const glm::dvec4> points, SpeedPiece& out) const;

  std::vector<double> products_;  ///< what the product of points i < j has in N, i after i
  std::vector<double> functions_;
  SpeedRule rule_;
  std::vector<double> sizes_;  ///< of the points
};

}  // namespace splinecore
#pragma GCC visibility pop
