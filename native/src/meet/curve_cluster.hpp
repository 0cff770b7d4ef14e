#pragma once

#include <optional>
#include <span>
#include <vector>

#include "curve_approach.hpp"
#include "curve_pairs.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// By how many places further both curves are counted: whole turns of closed ones.
struct Turns {
  double a = 0.0;
  double b = 0.0;
};

/// Stretches that follow each other on both curves, on closed ones beyond their ends.
class CurveCluster {
 public:
  explicit CurveCluster(const CurveStretch& first);

  /// The turns by which a stretch, or another cluster, goes on where this one is, up to the tolerance.
  std::optional<Turns> reaches(const TwoCurves& curves, const Interval& a, const Interval& b, double tolerance) const;
  void add(const CurveCluster& other, const Turns& turns);

  /// Places, as numbers, of both curves.
  const Interval& a() const noexcept { return a_; }
  const Interval& b() const noexcept { return b_; }
  bool is_trivial() const noexcept { return is_trivial_; }

  /// The nearest place of the second curve to a place of the first one.
  SpotPair at(const TwoCurves& curves, double place) const;

 private:
  struct Laid {
    CurveStretch stretch;
    Turns turns;
  };

  std::vector<Laid> stretches_;
  Interval a_;
  Interval b_;
  bool is_trivial_;
};

/// Stretches put together, in no order.
std::vector<CurveCluster> clusters_of(const TwoCurves& curves, std::vector<CurveStretch> stretches, double tolerance);

/// Whether a place of both curves is one of a cluster.
bool holds(const CurveCluster& cluster, const TwoCurves& curves, const SpotPair& at, double tolerance);

/// What a cluster is: a stretch that the curves have in common, or a place that they touch or cross at.
struct ClusterShape {
  bool is_overlap;
  SpotPair at;   ///< the place
  bool touches;  ///< whether tangents are parallel there
};

ClusterShape shape_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
