#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "basis/bernstein_net.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Bounds of |S_uu|, |S_uv| and |S_vv| over a piece; infinite where a weight is not above 0.
struct SecondDerivativeBounds {
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;

  /// How far a point of the piece may lie from the point with its parameters on any triangle in them whose corners
  /// are points of the piece (Filip, Magedson, Markot 1986, for triangles that lie in any way: by the variance of
  /// their corners).
  double distance() const noexcept { return (uu + 2.0 * uv + vv) / 8.0; }
};

/// Bounds the second derivatives of Bezier pieces, one after the other, in memory that it keeps.
class PieceBounds {
 public:
  explicit PieceBounds(bool rational) : rational_(rational) {}

  /// The piece that is bounded from now on; all its weights are 1 where it is not rational.
  void take(const BernsteinNet<glm::dvec4>& piece) { piece_ = &piece; }

  SecondDerivativeBounds bounds();

  /// Of the heights of the piece over a plane with this unit normal, once bounds() has been asked for.
  SecondDerivativeBounds bounds_along(const glm::dvec3& normal);

  /// How far a side of the piece may lie from its chord; the sides are u = 0, u = 1, v = 0, v = 1.
  double side_distance(int side);

 private:
  /// A piece seen from one of its points, so that sizes are those of the piece.
  struct Centered {
    std::vector<glm::dvec3> points;
    std::vector<double> weights;
    double least = 1.0;  ///< of the weights
  };

  void center(const glm::dvec4* points, std::size_t count, std::size_t middle, Centered& seen) const;
  template <class Value>
  SecondDerivativeBounds bounds_of(const Value* values, const Centered& seen, std::size_t rows,
                                   std::size_t columns) const;

  bool rational_;
  const BernsteinNet<glm::dvec4>* piece_ = nullptr;
  Centered seen_;
  Centered side_;
  std::vector<double> heights_;
  std::vector<glm::dvec4> side_points_;
};

}  // namespace splinecore
#pragma GCC visibility pop
