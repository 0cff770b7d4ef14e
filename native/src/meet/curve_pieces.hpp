#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "box_tree.hpp"
#include "near_space.hpp"
#include "slopes.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a curve: a piece, and t in [0, 1] of it.
struct CurveSpot {
  std::size_t piece;
  double t;
};

/// How far rounding moves a homogeneous point of a curve that runs along a unit vector there, across it: coordinates and
/// weight are sums of what `sums` has the absolute values of.
double rounding_across(const glm::dvec4& h, const glm::dvec4& sums, const glm::dvec3& along) noexcept;

/// The Bernstein pieces of a curve in a space that it shares with another one.
class CurvePieces {
 public:
  CurvePieces(const NurbsCurve& curve, const NearSpace& space);

  std::size_t size() const noexcept { return pieces_.size(); }
  const BernsteinNet<glm::dvec4>& piece(std::size_t i) const noexcept { return pieces_[i]; }
  /// Of a curve that runs through infinity the piece of the absolute values of what its coordinates, x, and weights, w,
  /// are sums of, by which these are rounded; of others an empty one.
  const BernsteinNet<glm::dvec4>& sums(std::size_t i) const noexcept { return sums_[i]; }
  const BoxTree& tree() const noexcept { return *tree_; }

  /// Whether the curve ends where it begins.
  bool is_closed() const noexcept { return goes_on_.back(); }

  /// The piece that goes on at an end of this one; none at an end of the curve and at a gap.
  std::optional<std::size_t> after(std::size_t i) const noexcept;
  std::optional<std::size_t> before(std::size_t i) const noexcept;

  Slopes<1> at(const CurveSpot& spot, const glm::dvec3& from = glm::dvec3(0.0)) const {
    const BernsteinNet<glm::dvec4>& net = pieces_[spot.piece];
    breathe(32 + 8 * net.values.size());
    return slopes_of<1>(kernels_, net.values.data(), net.rows, 1, {spot.t}, from);
  }

  /// How far rounding of coordinates and weights moves a place across the curve, where it is `here`.
  double rounding(const CurveSpot& spot, const Slopes<1>& here) const noexcept;

  /// Whether a speed is so low at a place that rounding may make all of it, where weights are much above that there.
  bool is_rounding(double speed, const CurveSpot& spot) const noexcept;

  double parameter(const CurveSpot& spot) const;

  /// Whether places are one up to a tolerance: the curve stays as near from one to the other, of a closed curve over its
  /// end, too.
  bool are_one(const CurveSpot& a, const CurveSpot& b, double tolerance) const;

  /// How far the places behind one, or before it (`way` -1), are within a distance of it: at most twice as far as to the
  /// first one that is not, and never over a gap.
  double reach(double place, double way, double distance) const;

  /// Whether the curve ends, or jumps, within a distance of a place.
  bool ends_near(double place, double distance) const;

  /// Piece and t as one number, which rises along the curve; after a gap it is one higher.
  double place(const CurveSpot& spot) const noexcept { return starts_[spot.piece] + spot.t; }
  /// Of a closed curve on any of its turns.
  CurveSpot spot(double place) const noexcept;
  /// The next place at which a piece ends, or the curve after a gap begins, behind one: of a closed curve on any of its turns.
  double end_behind(double place) const noexcept { return std::floor(place) + 1.0; }

  /// How much of the parameter a piece has.
  double span_length(std::size_t i) const { return knots_.span_interval(static_cast<int>(i)).length(); }

  /// By how much places of a closed curve rise in a turn.
  double turn() const noexcept { return starts_.back() + 1.0; }

 private:
  const Kernels& kernels_;
  KnotVector knots_;
  std::vector<BernsteinNet<glm::dvec4>> pieces_;
  std::vector<BernsteinNet<glm::dvec4>> sums_;
  std::vector<double> most_still_;  ///< of each piece the highest speed that rounding may make at a place of it
  std::vector<bool> goes_on_;  ///< after each piece, after the last one at the first
  std::vector<double> starts_;  ///< places of the starts of pieces
  std::optional<BoxTree> tree_;
};

}  // namespace splinecore
#pragma GCC visibility pop
