#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Of two closed sides that are one curve, run through from different beginnings or at different paces, where one is at a parameter
/// of the other.
class RimPlaces {
 public:
  RimPlaces(NurbsCurve first, NurbsCurve second);

  double on_first(double u_of_second) const;
  double on_second(double u_of_first) const;

  /// Shares of the way between parameters of the first by its length, which has no kinks where parameters have.
  std::vector<double> between(double from, double to, std::span<const double> shares) const;

  /// The largest distance between the curves that is seen.
  double gap() const;

 private:
  NurbsCurve first_;
  NurbsCurve second_;
  double length_;
};

/// Two patches beside an edge, v_start of both, u along it over [0, 1].
struct BesideEdge {
  NurbsPatch first;
  NurbsPatch second;
  bool is_reversed;                 ///< the second was turned
  std::optional<RimPlaces> places;  ///< where they do not run alike
};

/// Two patches whose sides are one edge, run alike if that can be had without moving a seam that matters: what ends in a point may
/// begin anywhere.
/// @returns none where the sides are no one curve
std::optional<BesideEdge> beside_rim(const NurbsPatch& first, const NurbsPatch& second, double tolerance);

/// Whether the sides u_start and u_end are one but for rounding.
bool is_closed(const NurbsPatch& patch);

/// Periodic along u. @throws as made_periodic()
NurbsPatch closed_up(const NurbsPatch& patch);

/// How far v_start of one is from that of the other at the same u.
double gap_between(const NurbsPatch& a, const NurbsPatch& b);

/// Places in every span of both patches along their edge.
std::vector<double> places_along(const NurbsPatch& a, const NurbsPatch& b);

}  // namespace splinecore
#pragma GCC visibility pop
