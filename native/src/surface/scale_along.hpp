#pragma once

#include <vector>

#include "fitted_rows.hpp"
#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A factor above 0 along a rail: what x of a curve is at its parameters.
class ScaleAlong {
 public:
  /// @param domain     of the rail as it was given
  /// @param is_closed  the rail is
  /// @throws InvalidShape as sweep() says
  ScaleAlong(const NurbsCurve& curve, const Interval& domain, bool is_closed);

  /// A closed rail may begin elsewhere: one turn behind the domain of the curve is there, too.
  double at(double parameter) const;

  bool is_one() const;
  double largest() const;

  /// Whether it goes on smoothly from the end of a closed rail to its start.
  bool goes_round() const { return goes_round_; }

  /// Inside the domain of a rail that begins where this one does or elsewhere.
  std::vector<RowJoint> joints(const Interval& rail) const;
  std::vector<double> corners(const Interval& rail) const;

 private:
  bool is_smooth_round() const;
  std::vector<RowJoint> inner_knots(const Interval& rail) const;

  const NurbsCurve& curve_;
  bool goes_round_ = false;
};

}  // namespace splinecore
#pragma GCC visibility pop
