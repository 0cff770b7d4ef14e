#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "box_tree.hpp"
#include "near_space.hpp"
#include "piece_side.hpp"
#include "slopes.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a patch: a piece, and (u, v) in [0, 1]² of it.
struct PatchSpot {
  std::size_t piece;
  std::array<double, 2> at;
};

/// The Bernstein pieces of a patch in a space that it shares with another shape.
class PatchPieces {
 public:
  PatchPieces(const NurbsPatch& patch, const NearSpace& space);

  std::size_t size() const noexcept { return pieces_.size(); }
  const BernsteinNet<glm::dvec4>& piece(std::size_t i) const noexcept { return pieces_[i]; }
  const BoxTree& tree() const noexcept { return *tree_; }

  /// The largest side of the box about all pieces.
  double extent() const noexcept { return extent_; }

  /// The piece that goes on at a side of this one, over the seam of a closed patch; none at a border and at a gap.
  std::optional<std::size_t> beyond(std::size_t piece, const PieceSide& side) const noexcept;

  /// A place, and the same one in the pieces beyond the sides that it is so near to.
  std::vector<PatchSpot> twins(const PatchSpot& spot, double near) const;

  /// Whether a side of a piece is a single point.
  bool is_pole(std::size_t piece, const PieceSide& side) const noexcept { return poles_[4 * piece + number(side)]; }

  Slopes<2> at(const PatchSpot& spot, const glm::dvec3& from = glm::dvec3(0.0)) const {
    const BernsteinNet<glm::dvec4>& net = pieces_[spot.piece];
    breathe(32 + 8 * net.values.size());
    return slopes_of<2>(kernels_, net.values.data(), net.rows, net.columns, spot.at, from);
  }

  const KnotVector& knots(Axis axis) const noexcept { return axis == Axis::u ? u_ : v_; }
  std::array<double, 2> parameters(const PatchSpot& spot) const;
  /// The place of parameters, of those beyond the domain by rounding at its side.
  PatchSpot spot(const std::array<double, 2>& parameters) const;
  std::size_t piece_in(std::size_t span_u, std::size_t span_v) const noexcept { return span_u * spans(Axis::v) + span_v; }

  /// How long the span of a piece is along an axis, in the patch's parameter.
  double span_length(std::size_t piece, Axis axis) const;

 private:
  static std::size_t number(const PieceSide& side) noexcept {
    return (side.axis == Axis::u ? 0U : 2U) + (side.is_end ? 1U : 0U);
  }
  std::size_t spans(Axis axis) const noexcept { return knots(axis).spans().size(); }
  std::size_t span(std::size_t piece, Axis axis) const noexcept {
    return axis == Axis::u ? piece / spans(Axis::v) : piece % spans(Axis::v);
  }
  bool are_joined(std::size_t before, std::size_t behind, Axis axis, double rounding) const;

  const Kernels& kernels_;
  KnotVector u_;
  KnotVector v_;
  std::vector<BernsteinNet<glm::dvec4>> pieces_;
  std::vector<bool> goes_on_;  ///< behind each piece along u, and along v
  std::vector<bool> poles_;    ///< sides of each piece
  std::optional<BoxTree> tree_;
  double extent_ = 0.0;
};

}  // namespace splinecore
#pragma GCC visibility pop
