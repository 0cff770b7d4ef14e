#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "boxed_pieces.hpp"
#include "distance_form.hpp"
#include "kernels/kernels.hpp"
#include "slopes.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A place of a shape, in the space of its pieces.
struct NearestPlace {
  std::array<double, 2> parameters{};
  double squared = std::numeric_limits<double>::infinity();  ///< its distance from the point
  glm::dvec3 point{0.0};

  bool found() const noexcept { return squared < std::numeric_limits<double>::infinity(); }
};

/// Looks for the nearest point of curves (kAxes = 1) and patches (2), one query after the other, in memory of its own.
///
/// Branch and bound (Johnson and Cohen 1998): parts of pieces are looked at by the distance of their boxes, the nearest
/// first, and left out when no point of theirs can be nearer than what was found. Newton's method goes down to a
/// minimum, borders and corners included; a part is halved unless its DistanceForm shows that this is its least one.
template <int kAxes>
class NearestSearch {
 public:
  explicit NearestSearch(const BoxedPieces& pieces);

  /// Of places at one distance, up to rounding, the one with the smallest parameters.
  /// @param within  what is farther, but for rounding, is not looked for
  NearestPlace nearest(const glm::dvec3& point, double within = std::numeric_limits<double>::infinity());

 private:
  using Net = BernsteinNet<glm::dvec4>;
  using Range = std::array<Interval, 2>;
  using Place = std::array<double, kAxes>;

  struct Waiting {
    double squared;
    std::uint32_t level;  ///< 0: a part; 1: a group of parts; from 2 on one of the tree
    std::uint32_t index;
  };

  void push_boxes(std::size_t level, std::size_t group);
  void push_parts(std::size_t group);
  void push(const double* squared, std::size_t count, std::size_t level, std::size_t first);
  void look_at(const Waiting& waiting);

  /// Whether a part may have a place that is nearer, or earlier of those as near.
  /// @param squared  no point of the part is nearer than its root
  bool may_hold(double squared, const PiecePart& part, const Range& range) const noexcept;

  /// Looks at what a part is on a range of its piece, and halves it where it must.
  void look_into(const PiecePart& part, const glm::dvec4* net, const Range& range, Place start, std::size_t depth);

  /// Goes down from a place in the net's own parameters as long as steps lead down, and offers where they end.
  /// @returns the square of its distance if it is a minimum, or -1
  double go_down(const PiecePart& part, const glm::dvec4* net, const Range& range, Place& at);

  void set_limits() noexcept;
  /// @throws InvalidShape after too many.
  void count_look();
  Slopes<kAxes> slopes(const glm::dvec4* net, const Place& at) noexcept;
  void offer(const PiecePart& part, const Range& range, const Place& at, const glm::dvec3& offset) noexcept;

  const BoxedPieces& pieces_;
  std::size_t rows_;
  std::size_t columns_;
  std::array<double, 2> apart_{};  ///< parameters that are nearer to each other are one for the order of places
  glm::dvec3 point_{0.0};
  NearestPlace best_;
  std::size_t looks_ = 0;
  double rounding_ = 0.0;  ///< distances that differ by no more are one
  double least_ = 0.0;  ///< the square of the least distance that was found
  double below_ = 0.0;  ///< squares of distances that are surely less, and
  double above_ = 0.0;  ///< surely more
  std::vector<Waiting> waiting_;  ///< as many as can wait at once: a group for each level
  std::size_t waiting_count_ = 0;
  const Kernels& kernels_ = kernels();
  std::vector<std::array<Net, 2>> nets_;  ///< for each depth of halving
  DistanceForm form_;
};

extern template class NearestSearch<1>;
extern template class NearestSearch<2>;

}  // namespace splinecore
#pragma GCC visibility pop
