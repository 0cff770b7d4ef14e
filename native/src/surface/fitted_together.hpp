#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A parameter at which a derivative of a curve jumps that is as smooth as a knot with so many copies allows.
struct Crease {
  double at;
  int times;
};

/// What several curves have in common that are fitted on one knot vector.
struct FitTogether {
  std::size_t count;             ///< of curves
  int degree;
  Interval domain;
  bool is_periodic;
  std::vector<double> corners;   ///< parameters at which one has a corner, its seam among them
  double tolerance;
  std::vector<Crease> creases = {};  ///< where they need knots; corners may be among them
};

/// Curve i on these knots, and how far it is from what it should be.
using FitOne = std::function<Approximation<NurbsCurve>(std::size_t i, const KnotVector& knots)>;

/// Curves on one knot vector with few spans between corners and creases: found by doubling and halving, curve after curve. They are
/// even up to 32; of more each is as long as its part of the curves lets it.
/// @returns the curves, and the largest of their errors
/// @throws ToleranceNotReached if 4096 spans do not come within the tolerance; InvalidShape unless it is positive.
Approximation<std::vector<NurbsCurve>> fitted_together(const FitTogether& what, const FitOne& fit);

/// Parameters at which one of the curves, which have one domain, has a corner, in order, each once.
std::vector<double> corners_of(std::span<const NurbsCurve> curves);

/// Where a curve jumps in one of its first derivatives, up to a degree, or all but jumps between knots that nearly coincide, in order.
std::vector<Crease> creases_of(const NurbsCurve& curve, int degree);

}  // namespace splinecore
#pragma GCC visibility pop
