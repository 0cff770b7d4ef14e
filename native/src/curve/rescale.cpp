#include "rescale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "basis/knot_tables.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

/// Smallest and largest exponent of numbers that are not zero.
class ExponentRange {
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
  int allowed(int wanted) const { return without_overflow(std::min(wanted, least_ + kRange)); }

  int without_overflow(int wanted) const { return std::max(wanted, most_ - kRange); }

 private:
  static constexpr int kRange = 1020;
  int least_ = 0;
  int most_ = 0;
  bool any_ = false;
};

/// 0 where products of a few numbers stay in range as they are.
int needed(int exponent) {
  constexpr int kNear = 100;
  return std::abs(exponent) < kNear ? 0 : exponent;
}

}  // namespace

Scales scales_of(const NurbsCurve& curve) { return shared_scales(curve, curve); }

Scales shared_scales(const NurbsCurve& a, const NurbsCurve& b) {
  ExponentRange coordinates;
  ExponentRange knots;
  ExponentRange weights;
  for (const NurbsCurve* curve : {&a, &b}) {
    for (const glm::dvec4& point : curve->points()) {
      for (int axis = 0; axis < 3; ++axis) coordinates.add(point[axis]);
    }
    for (const double knot : curve->knot_vector().knots()) knots.add(knot);
  }
  for (const glm::dvec4& point : a.points()) weights.add(point.w);
  ExponentRange sizes;
  sizes.add(std::max(largest_coordinate(a.points()), largest_coordinate(b.points())));
  const int lengths = std::ilogb(a.domain().length()) + std::ilogb(b.domain().length());
  return {coordinates.without_overflow(needed(sizes.most())), weights.allowed(needed(weights.most())),
          knots.allowed(needed(lengths / 2))};
}

int scale_of(const KnotVector& knots) {
  const int wanted = needed(std::ilogb(knots.domain().length()));
  if (wanted == 0) return 0;
  ExponentRange exponents;
  for (const double knot : knots.knots()) exponents.add(knot);
  return exponents.allowed(wanted);
}

KnotVector divided(const KnotVector& knots, int exponent) {
  if (exponent == 0) return knots;
  std::vector<double> divided(knots.knots().begin(), knots.knots().end());
  for (double& knot : divided) knot = std::scalbn(knot, -exponent);
  return KnotVector::make(knots.degree(), std::move(divided), knots.periodic());
}

ScaledKnots near_one(const KnotVector& knots) {
  if (const ScaledKnots* known = knots.tables().scaled()) return *known;
  const int exponent = scale_of(knots);
  if (exponent == 0) return {0, knots};
  return knots.tables().keep({exponent, divided(knots, exponent)});
}

NurbsCurve divided(const NurbsCurve& curve, const Scales& scales) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  for (glm::dvec4& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = std::scalbn(point[axis], -scales.coordinates);
    point.w = std::scalbn(point.w, -scales.weights);
  }
  return NurbsCurve::make(divided(curve.knot_vector(), scales.parameters), std::move(points));
}

}  // namespace splinecore
