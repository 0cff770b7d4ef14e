#pragma once

#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How densely knots are wanted over a domain: even at first, then as the curves ask for that were fitted last, for the same error in
/// every span (de Boor, A Practical Guide to Splines, XII), and nowhere less than a share of the even ones.
class KnotDensity {
 public:
  explicit KnotDensity(const Interval& domain);

  bool is_even() const { return wants_.size() == 1; }

  /// Also where this curve, on many spans, changes its highest derivative. At breaks it may do so without need of others.
  void take(const NurbsCurve& curve, std::span<const double> breaks);

  /// The part of all knots that lies in an interval.
  double share(double from, double to) const { return at(to) - at(from); }

  /// Knots between both ends that part it into as many pieces of one share.
  std::vector<double> parted(double from, double to, int pieces) const;

 private:
  double at(double place) const;
  double place_of(double share) const;
  void sum_up();

  std::vector<double> places_;  ///< ends of intervals, in order
  std::vector<double> wants_;   ///< in each, by length
  std::vector<double> sums_;    ///< shares up to each end
};

}  // namespace splinecore
#pragma GCC visibility pop
