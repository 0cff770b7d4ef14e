#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// The homogeneous Bezier points of the span that was asked for last. Parameters mostly come in
/// order, so one span serves many; the value at a parameter is the same in any order.
class SpanCursor {
 public:
  explicit SpanCursor(const NurbsCurve& curve);

  /// The homogeneous point at a parameter that KnotVector::admit() let through.
  glm::dvec4 at(double u, Side side);

 private:
  void enter(int span);

  const NurbsCurve& curve_;
  Interval range_;
  std::vector<double> binomials_;
  std::vector<glm::dvec4> points_;
};

}  // namespace splinecore
