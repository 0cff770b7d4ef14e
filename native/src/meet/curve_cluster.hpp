#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/rounding.hpp"
#include "curve_approach.hpp"
#include "curve_pairs.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// By how many places further both curves are counted: whole turns of closed ones.
struct Turns {
  double a = 0.0;
  double b = 0.0;
};

/// A stretch of both curves where it is counted, as places.
struct LaidStretch {
  CurveStretch stretch;
  Turns turns;
  Interval a;
  Interval b;
};

/// What two curves have in common that hangs together: they are within the tolerance of each other all the way.
class CurveCluster {
 public:
  void add(const LaidStretch& laid);
  void add(const SpotPair& crossing) { crossings_.push_back(crossing); }
  void set_trivial() noexcept { is_trivial_ = true; }

  /// Places, as numbers, of both curves: on closed ones beyond their ends.
  const Interval& a() const noexcept { return a_; }
  const Interval& b() const noexcept { return b_; }
  bool has_stretches() const noexcept { return !stretches_.empty(); }
  const std::vector<SpotPair>& crossings() const noexcept { return crossings_; }

  /// Whether a curve goes on from one of the parts to the other.
  bool is_trivial() const noexcept { return is_trivial_; }

  /// Whether it goes round a closed first curve, but for rounding.
  bool is_round(const TwoCurves& curves) const noexcept {
    return curves.a.is_closed() && a_.length() >= (1.0 - kRoundingOfPlace) * curves.a.turn();
  }

  /// Adds where stretches end along the first curve, of many every so many, held in an interval.
  void add_ends(std::vector<double>& places, const Interval& in) const;

  /// The longest part of an interval of the first curve along which both are in one piece.
  Interval longest_in_pieces(const Interval& in) const;

  /// Whether a place of the first curve is in a stretch.
  bool holds(const TwoCurves& curves, double place) const;

  /// The nearest place of the second curve to a place of the first one.
  SpotPair at(const TwoCurves& curves, double place) const;

  /// Where they are nearest in stretches, of which there are some, each looked at.
  SpotPair nearest(const TwoCurves& curves) const;

 private:
  std::vector<LaidStretch> stretches_;
  std::vector<SpotPair> crossings_;
  Interval a_;
  Interval b_;
  bool is_trivial_ = false;
};

/// Curves are looked at within so many tolerances: what rounding parts at the edge of the tolerance hangs together so.
/// What stays farther apart than the tolerance is left out in the end.
inline constexpr double kWide = 1.25;

/// All findings put together, in no order.
/// @param findings  within kWide tolerances
std::vector<CurveCluster> clusters_of(const TwoCurves& curves, const PairFindings& findings, double tolerance);

/// What a cluster is: a stretch that the curves have in common, or a place that they touch or cross at; or nothing, for
/// parts may be near though no places are.
struct ClusterShape {
  std::optional<Interval> overlap;  ///< places of the first curve
  std::optional<SpotPair> at{};     ///< the place
  bool touches = false;             ///< whether tangents are parallel there
};

/// The places of the first curve along which curves are one, evenly near or from end to end; none where they but touch
/// or cross.
std::optional<Interval> overlap_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance);
ClusterShape shape_of(const CurveCluster& cluster, const TwoCurves& curves, double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
