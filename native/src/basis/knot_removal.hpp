#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Rows of homogeneous points on a plain knot vector, from which knots are taken one after the other.
///
/// A list of knots, each with the row whose function begins there: taking one costs what its neighbors cost, however
/// long the list is. What a removal makes is the nearest in its rows, in the sum of squares (The NURBS Book, 5.4 and
/// A5.8; of the one equation that is too many the residue is known in closed form).
class KnotList {
 public:
  /// @param width  points of a row
  KnotList(const KnotVector& knots, std::vector<glm::dvec4> rows, std::size_t width);

  /// The last copies of all inner knots, in order.
  std::vector<int> inner() const;

  int degree() const noexcept { return degree_; }
  double knot(int i) const noexcept { return nodes_[i].knot; }

  /// How far a point would move at most if one copy of knot i, its last, went, as the weights around it tell; infinite
  /// where they tell nothing.
  double cost(int i) const;

  /// A few roundings of the largest coordinate.
  double rounding() const;

  /// From the first to the last knot that a removal of knot i concerns.
  double reach(int i) const;

  /// Takes knot i, the last of its copies. Returns the knot before it.
  int remove(int i);

  /// Adds to the error of every span that the removal of knot i concerns.
  void add_error(int i, double error);

  /// The largest error of these spans.
  double error_around(int i) const;

  /// The last copies of the knots whose cost the removal of the knot after `before` may have changed.
  std::vector<int> around(int before) const;

  /// What is left.
  struct Rest {
    KnotVector knots;
    std::vector<glm::dvec4> rows;
    std::vector<int> origins;  ///< of each row: which of the first ones it still is, or -1
  };
  Rest rest() const;

  /// The rows that make up the spans which a removal of knot i concerns, on their knots.
  Rest around_of(int i) const;

 private:
  struct Node {
    double knot;
    int before;
    int after;
    int origin;
    double error = 0.0;  ///< of the span that begins here
  };
  struct Window;
  Window window_of(int i) const;
  bool is_inner(int i) const noexcept;
  Rest rest_of(const std::vector<int>& nodes) const;
  const glm::dvec4* row(int i) const noexcept { return rows_.data() + i * width_; }
  glm::dvec4* row(int i) noexcept { return rows_.data() + i * width_; }

  int degree_;
  std::size_t width_;
  Interval domain_;
  std::vector<Node> nodes_;
  std::vector<glm::dvec4> rows_;
};

/// Which knots to take, least error first, so that by their costs no point moves farther than the tolerance.
/// @param kept   values of knots that stay, in order
/// @param judge  (list, i): how far the removal really moves a point, where the cost tells nothing or is just too much
using Judge = std::function<double(const KnotList&, int)>;
std::vector<int> removal_order(KnotList list, double tolerance, std::span<const double> kept, const Judge& judge);

}  // namespace splinecore
#pragma GCC visibility pop
