#pragma once

#include <vector>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The pace under which a curve is at wanted parameters where it was at given ones: a map that rises from one to the
/// other, by cubics between them. They join smoothly where the cubic spline through all rises, else with the slopes of
/// Fritsch and Butland (1984).
class Pacing {
 public:
  /// @param wanted  increasing, as `given`, and as many; of a periodic curve from the start to the end of a period
  Pacing(std::vector<double> wanted, std::vector<double> given, bool is_periodic);

  /// The parameter of the curve at one of those wanted.
  double at(double u) const;

  /// Whether second derivatives go on, too.
  bool is_smooth() const { return is_smooth_; }

 private:
  bool rises() const;

  std::vector<double> wanted_;
  std::vector<double> given_;
  std::vector<double> slopes_;
  bool is_smooth_ = false;
};

}  // namespace splinecore
#pragma GCC visibility pop
