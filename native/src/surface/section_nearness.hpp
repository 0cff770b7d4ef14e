#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How near beginnings bring a curve to another one: the cosine of the angle between both, each as one vector of points at even
/// parameters about their middle. So of all beginnings that of a copy is the nearest, whatever its size.
class SectionNearness {
 public:
  /// @param curve  outlives this
  SectionNearness(const NurbsCurve& other, const NurbsCurve& curve);

  double at(double begin) const;

  /// The beginning of a periodic curve that is nearest of even ones, then where the nearness ceases to grow between those
  /// beside it.
  double best() const;

 private:
  double growth(double begin) const;

  const NurbsCurve& curve_;
  std::vector<glm::dvec3> other_;
  double size_;
};

}  // namespace splinecore
#pragma GCC visibility pop
