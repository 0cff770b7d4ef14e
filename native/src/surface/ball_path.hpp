#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "rolling_ball.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The arc in which a ball touches what it leaves behind.
struct BallArc {
  glm::dvec3 first;
  glm::dvec3 second;
  glm::dvec3 center;
  double radius;

  /// A point of it, as a conic has it: from the first contact at v = 0 to the second one at 1.
  glm::dvec3 at(double v) const;
};

/// The arcs of a ball along an edge, from polynomials between the places at which its way is less smooth: for very many of them.
class BallPath {
 public:
  /// @param range      parameters of the first patch along the edge; others are asked of the ball
  /// @param is_closed  all that differ by 1 are one
  /// @param within     how far polynomials may be off
  BallPath(const RollingBall& ball, const Interval& range, bool is_closed, double within);

  BallArc at(double u) const;

  /// By how much polynomials were found to be off.
  double error() const { return error_; }

 private:
  /// Without values the ball itself is asked.
  struct Part {
    Interval range;
    std::vector<double> values;
  };

  void add(const Interval& range, double width, double within);

  const RollingBall& ball_;
  bool is_closed_;
  double error_ = 0.0;
  std::vector<Part> parts_;
};

}  // namespace splinecore
#pragma GCC visibility pop
