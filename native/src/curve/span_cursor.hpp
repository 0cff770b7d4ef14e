#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The homogeneous Bezier points of spans, computed when first asked for. The value at a parameter
/// is the same in any order of asking.
class SpanCursor {
 public:
  /// @param batch  how many parameters will come: with fewer than there are spans, only the span
  ///               that was asked for last is kept
  SpanCursor(const NurbsCurve& curve, std::size_t batch);

  /// The homogeneous point at a parameter that KnotVector::admit() let through.
  glm::dvec4 at(double u, Side side);

 private:
  void enter(int span);

  void compute(int span);

  const NurbsCurve& curve_;
  std::size_t order_;
  bool keeps_all_;
  int span_ = -1;
  Interval range_;
  const glm::dvec4* points_ = nullptr;
  std::vector<double> binomials_;
  std::vector<char> is_known_;
  std::vector<glm::dvec4> memory_;
};

}  // namespace splinecore
#pragma GCC visibility pop
