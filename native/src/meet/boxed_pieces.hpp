#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "basis/bernstein_net.hpp"
#include "box_tree.hpp"
#include "near_space.hpp"
#include "piece_box.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A part of the Bernstein piece on a span, or on a pair of spans, that hardly bends.
struct PiecePart {
  std::array<Interval, 2> domain;  ///< the shape's parameters over the whole piece
  std::array<Interval, 2> range;   ///< of the part, in [0, 1]
  bool is_boxed;                   ///< or its weights have both signs
  PieceBox box;
};

/// The Bernstein pieces of a curve or a patch in a space of their own, cut into parts, and the tree of their boxes.
class BoxedPieces {
 public:
  explicit BoxedPieces(const NurbsCurve& curve);
  explicit BoxedPieces(const NurbsPatch& patch);

  const NearSpace& space() const noexcept { return space_; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t columns() const noexcept { return columns_; }

  std::span<const PiecePart> parts() const noexcept { return parts_; }

  /// The homogeneous control points of a part, row after row; of a curve one column.
  const glm::dvec4* points(std::size_t part) const noexcept { return points_.data() + part * rows_ * columns_; }

  /// The boxes of so many neighbors at once, and their tree, of which they are the leaves.
  static constexpr std::size_t kGroup = kBoxGroup;
  std::span<const TurnedBoxGroup> groups() const noexcept { return groups_; }
  const BoxTree& tree() const noexcept { return tree_; }

 private:
  using Net = BernsteinNet<glm::dvec4>;

  void cut(const Net& net, const std::array<Interval, 2>& domain, const std::array<Interval, 2>& range, int depth);

  /// Neighbors on a patch come one after the other.
  /// @param codes  of parts: they are sorted by these
  void put_in_order(std::span<const std::uint64_t> codes);
  BoxTree tree_of_groups();

  NearSpace space_;
  std::size_t rows_;
  std::size_t columns_;
  std::vector<PiecePart> parts_;
  std::vector<glm::dvec4> points_;
  std::vector<TreeBox> boxes_;  ///< of the parts, along the axes of coordinates, while they are put together
  std::vector<TurnedBoxGroup> groups_;
  BoxTree tree_;
};

/// Those of a curve or a patch, made once.
const BoxedPieces& boxed_pieces(const NurbsCurve& curve);
const BoxedPieces& boxed_pieces(const NurbsPatch& patch);

}  // namespace splinecore
#pragma GCC visibility pop
