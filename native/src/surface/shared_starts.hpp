#pragma once

#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Knots of closed curves that are to be united, as parts of their domains; and where others begin so that theirs are among them.
class SharedStarts {
 public:
  /// @param curve  as it is begun
  void add(const NurbsCurve& curve);

  /// Where a periodic curve begins that best began at a parameter: near to it, where most of its knots are one with those
  /// that are there; at the parameter itself where none would be. Without that, knots would lie beside others by as little
  /// as beginnings are off, and faces between them would have no length.
  ///
  /// Near is 1/512 of the period, or 1/16 of a mean span, where that is less.
  double start_near(const NurbsCurve& curve, double best) const;

 private:
  std::vector<double> shares_;  ///< in [0, 1), in order
  std::size_t most_ = 1;        ///< knots of one curve
};

}  // namespace splinecore
#pragma GCC visibility pop
