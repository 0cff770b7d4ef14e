#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "basis/bernstein_row.hpp"
#include "second_derivatives.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Largest angles between unit normals, along each direction and of all.
struct NormalAngles {
  double u = 0.0;
  double v = 0.0;
  double all = 0.0;
};

/// Points and normals of Bezier pieces of one bidegree at 3 x 3 places, one piece after the other, in memory that it
/// keeps; each is found when it is first asked for.
///
/// The places are 0, 1/2 and 1 of each direction, u first. Where a normal vanishes that of a place beside it stands for
/// it, or (0, 0, 0).
class NinePlaces {
 public:
  NinePlaces(int degree_u, int degree_v, bool rational);

  /// The piece that is measured from now on; all its weights are 1 where it is not rational.
  void take(const BernsteinNet<glm::dvec4>& piece);

  /// The normal in the middle.
  glm::dvec3 middle_normal();

  NormalAngles normal_angles();
  /// The sine of the largest angle, 1 where it is a right angle or more.
  double largest_sine();
  /// At least as much at no cost, when the normal in the middle has been asked for.
  /// @param bounds  of the piece
  double sine_bound(const SecondDerivativeBounds& bounds) const;

  /// The shorter and the longer of the two sides along a direction, by way of their middles.
  std::pair<double, double> lengths(Axis axis);
  /// Of the three lines along a direction.
  double longest(Axis axis);
  /// How far the middle of a line along a direction lies from its chord, at most.
  double sagitta(Axis axis);

 private:
  /// Two of the nine places.
  struct Pair {
    int a = 0;
    int b = 0;
    double chord = 0.0;  ///< between the normals, squared
  };
  struct Pairs {
    Pair u, v, all;
  };

  double length(Axis axis, int line);
  void blend_values();
  void blend_slopes();
  const std::array<glm::dvec3, 9>& points();
  const std::array<glm::dvec3, 9>& normals();
  const Pairs& farthest_normals();
  glm::dvec3 normal_near(int place, double magnitude) const;

  bool rational_;
  std::array<BernsteinRow, 3> u_, v_;            ///< at 0, 1/2 and 1
  std::array<BernsteinRow, 3> inner_u_, inner_v_;  ///< a little inside
  const BernsteinNet<glm::dvec4>* piece_ = nullptr;
  std::vector<glm::dvec4> row_values_, row_slopes_;  ///< of each row at the three places along v
  std::array<glm::dvec4, 9> values_;
  std::array<glm::dvec3, 9> points_;
  std::array<glm::dvec3, 9> normals_;
  std::array<glm::dvec3, 2> middle_slopes_{};  ///< along u and v, as far as known
  Pairs pairs_;
  bool has_values_ = false;
  bool has_points_ = false;
  bool has_normals_ = false;
  bool has_pairs_ = false;
};

}  // namespace splinecore
#pragma GCC visibility pop
