#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Which point a row of weights is a copy of, because no other has a part in it; -1 where none is.
int copied_point(std::span<const double> row) noexcept;

/// The sparse matrix that takes the control points on one knot vector to those on another.
///
/// Row j holds `width` weights, all in [0, 1], for the old points first(j), first(j) + 1, …, modulo the old
/// count where periodic. A point that stays as it is has one weight, 1: it is copied bit for bit.
class PointMatrix {
 public:
  struct Rows {
    std::ptrdiff_t width = 0;
    std::vector<std::ptrdiff_t> first;
    std::vector<double> weights;  // width for each row
  };

  PointMatrix(KnotVector from, KnotVector to, Rows rows)
      : from_(std::move(from)), to_(std::move(to)), rows_(std::move(rows)) {}

  /// The knots of the old points.
  const KnotVector& from() const noexcept { return from_; }

  /// The knots of the new points.
  const KnotVector& knots() const noexcept { return to_; }

  /// The new homogeneous points: out[j * out_stride] from points[i * stride].
  void apply(const glm::dvec4* points, std::size_t stride, glm::dvec4* out, std::size_t out_stride) const;

  /// The transposed matrix: from().count() points out of knots().count().
  std::vector<glm::dvec4> apply_transposed(const std::vector<glm::dvec4>& points) const;

  /// Copies only the points that stay as they are, in whatever form.
  void keep_untouched(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                      std::size_t out_stride) const;

 private:
  std::span<const double> row(std::size_t j) const noexcept {
    return {rows_.weights.data() + j * rows_.width, static_cast<std::size_t>(rows_.width)};
  }
  std::size_t old_index(std::size_t j, std::ptrdiff_t r) const noexcept;

  KnotVector from_;
  KnotVector to_;
  Rows rows_;
};

}  // namespace splinecore
#pragma GCC visibility pop
