#include "splinecore/curve/rescale.hpp"

#include <algorithm>
#include <cmath>

#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// Smallest and largest exponent of numbers that are not zero.
class Exponents {
 public:
  void add(double value) {
    if (value == 0.0) return;
    const int exponent = std::ilogb(value);
    least_ = any_ ? std::min(least_, exponent) : exponent;
    most_ = any_ ? std::max(most_, exponent) : exponent;
    any_ = true;
  }

  int most() const { return most_; }

  /// The one nearest to `wanted` by which all of the numbers can be divided without a loss.
  int allowed(int wanted) const {
    constexpr int kRange = 1020;
    return std::max(std::min(wanted, least_ + kRange), most_ - kRange);
  }

 private:
  int least_ = 0;
  int most_ = 0;
  bool any_ = false;
};

}  // namespace

Scales scales_of(const NurbsCurve& curve) { return shared_scales(curve, curve); }

Scales shared_scales(const NurbsCurve& a, const NurbsCurve& b) {
  Exponents coordinates;
  Exponents knots;
  Exponents weights;
  for (const NurbsCurve* curve : {&a, &b}) {
    for (const glm::dvec4& point : curve->points()) {
      for (int axis = 0; axis < 3; ++axis) coordinates.add(point[axis]);
    }
    for (const double knot : curve->knot_vector().knots()) knots.add(knot);
  }
  for (const glm::dvec4& point : a.points()) weights.add(point.w);
  Exponents sizes;
  sizes.add(std::max(largest_coordinate(a.points()), largest_coordinate(b.points())));
  const int lengths = std::ilogb(a.domain().length()) + std::ilogb(b.domain().length());
  return {coordinates.allowed(sizes.most()), weights.allowed(weights.most()), knots.allowed(lengths / 2)};
}

NurbsCurve divided(const NurbsCurve& curve, const Scales& scales) {
  std::vector<double> knots(curve.knot_vector().knots().begin(), curve.knot_vector().knots().end());
  for (double& knot : knots) knot = std::scalbn(knot, -scales.parameters);
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = std::scalbn(point[axis], -scales.coordinates);
    point.w = std::scalbn(point.w, -scales.weights);
  }
  return NurbsCurve::make(KnotVector::make(curve.degree(), std::move(knots), curve.periodic()), std::move(points));
}

}  // namespace splinecore
