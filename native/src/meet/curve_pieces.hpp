#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "box_tree.hpp"
#include "near_space.hpp"
#include "slopes.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a curve: a piece, and t in [0, 1] of it.
struct CurveSpot {
  std::size_t piece;
  double t;
};

/// The Bernstein pieces of a curve in a space that it shares with another one.
class CurvePieces {
 public:
  CurvePieces(const NurbsCurve& curve, const NearSpace& space);

  std::size_t size() const noexcept { return pieces_.size(); }
  const BernsteinNet<glm::dvec4>& piece(std::size_t i) const noexcept { return pieces_[i]; }
  const BoxTree& tree() const noexcept { return *tree_; }

  /// Whether the curve ends where it begins.
  bool is_closed() const noexcept { return goes_on_.back(); }

  /// The piece that goes on at an end of this one; none at an end of the curve and at a gap.
  std::optional<std::size_t> after(std::size_t i) const noexcept;
  std::optional<std::size_t> before(std::size_t i) const noexcept;

  Slopes<1> at(const CurveSpot& spot, const glm::dvec3& from = glm::dvec3(0.0)) const noexcept {
    const BernsteinNet<glm::dvec4>& net = pieces_[spot.piece];
    return slopes_of<1>(kernels_, net.values.data(), net.rows, 1, {spot.t}, from);
  }

  double parameter(const CurveSpot& spot) const;

  /// Whether stretches of places are next to each other, and not farther apart than that.
  bool are_beside(const Interval& a, const Interval& b, double tolerance) const noexcept;

  /// Whether places are next to each other, over the end of a closed curve, too, and as near.
  bool are_one(const CurveSpot& a, const CurveSpot& b, double tolerance) const noexcept;

  /// Piece and t as one number, which rises along the curve.
  static double place(const CurveSpot& spot) noexcept { return static_cast<double>(spot.piece) + spot.t; }
  /// Of a closed curve on any of its turns.
  CurveSpot spot(double place) const noexcept;

 private:
  const Kernels& kernels_;
  KnotVector knots_;
  std::vector<BernsteinNet<glm::dvec4>> pieces_;
  std::vector<bool> goes_on_;  ///< after each piece, after the last one at the first
  std::optional<BoxTree> tree_;
};

}  // namespace splinecore
#pragma GCC visibility pop
