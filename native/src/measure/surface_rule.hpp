#pragma once

#include <array>
#include <compare>
#include <glm/vec3.hpp>
#include <vector>

#include "basis/bernstein_net.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What is integrated over a surface: |S_u x S_v|, or S · (S_u x S_v) / 3.
enum class Integrand { area, volume };

/// An integral over a piece, how far it is from those by rules with fewer nodes along u and along v, and the integral
/// of the size of the terms that it is made of, to which its rounding is relative.
struct PieceIntegral {
  double value = 0.0;
  std::array<double, 2> errors{};  ///< along u and along v
  double terms = 0.0;

  double error() const { return errors[0] + errors[1]; }
};

/// How the weights differ along a direction.
struct Unevenness {
  double ratio = 1.0;   ///< how often at most: infinite where they have both signs
  double spread = 0.0;  ///< by how much at most

  auto operator<=>(const Unevenness&) const = default;
};

/// A Bezier piece of a surface, homogeneous.
struct SurfacePiece {
  BernsteinNet<glm::dvec4> net;
  glm::dvec3 origin{0.0};  ///< of its points
  glm::dvec3 extent{0.0};  ///< the largest of their coordinates, before it was cut
  bool is_mixed = false;   ///< before it was cut its weights had both signs

  Unevenness unevenness(Axis axis) const;

  /// Both halves: this becomes the first.
  void halve(Axis axis, SurfacePiece& second);

  /// Brings weights that are all small near 1.
  void normalize();
};

/// The rules of Gauss and Kronrod of 10 and 21 nodes (Kronrod 1965; QUADPACK's QK21) on pieces of two degrees.
class SurfaceIntegral {
 public:
  SurfaceIntegral(int degree_u, int degree_v);

  PieceIntegral operator()(const SurfacePiece& piece, Integrand integrand);

 private:
  /// Bernstein polynomials of a degree at the nodes, one after the other; their slopes; the sums of the slopes' sizes.
  struct Functions {
    explicit Functions(int degree);

    std::vector<double> values;
    std::vector<double> slopes;
    std::vector<double> steps;
  };

  void sum_line(const BernsteinNet<glm::dvec4>& net, std::size_t node);

  Functions u_;
  Functions v_;
  std::vector<glm::dvec4> points_;  ///< along v, at a node along u
  std::vector<glm::dvec4> slopes_;
};

}  // namespace splinecore
#pragma GCC visibility pop
