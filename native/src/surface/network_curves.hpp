#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The curves of one direction of a network, in order, each run through in one direction, from the first of the others
/// to the last, or if closed from the first one round to it again.
/// Where a closed curve that begins elsewhere now began before, and over which domain it ran then.
struct FormerSeam {
  double at;
  Interval domain;
};

struct NetworkFamily {
  std::vector<NurbsCurve> curves;
  /// [i][j]: where curve i meets curve j of the others; if closed one more, a period behind the first.
  std::vector<std::vector<double>> crossings;
  std::vector<std::size_t> order{};  ///< which of the given ones each is
  std::vector<FormerSeam> seams{};  ///< of closed ones
  bool is_closed = false;
};

struct NetworkCurves {
  NetworkFamily u;
  NetworkFamily v;
  double missed = 0.0;  ///< the largest distance at which two pass each other
};

/// @throws InvalidShape as network()
NetworkCurves network_curves(std::span<const NurbsCurve> along_u, std::span<const NurbsCurve> along_v, double gap,
                             double unit);

}  // namespace splinecore
#pragma GCC visibility pop
