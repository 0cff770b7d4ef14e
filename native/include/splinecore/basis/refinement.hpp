#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

/// Knots with more of them, and the matrix that takes control points from the old to the new.
///
/// Row j of the matrix holds degree + 1 weights, all in [0, 1], for the old points
/// first(j) … first(j) + degree, modulo the old count where periodic. A point whose knots did
/// not change has one weight 1: it is copied bit for bit.
class Refinement {
 public:
  /// @param inserted  parameters of the domain, in any order, repeated for more multiplicity
  /// @throws InvalidShape if one lies outside the domain or its multiplicity would exceed degree + 1.
  static Refinement make(const KnotVector& knots, std::span<const double> inserted);

  const KnotVector& knots() const noexcept { return refined_; }

  /// The new homogeneous points: out[j * out_stride] from points[i * stride].
  void apply(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
             std::size_t out_stride) const;

  /// Copies only the points that the refinement leaves as they are, in whatever form.
  void keep_untouched(const glm::dvec4* points, std::size_t stride, glm::dvec4* out,
                      std::size_t out_stride) const;

 private:
  struct Rows {
    std::vector<long> first;
    std::vector<double> weights;
  };
  long old_index(std::size_t j, long r) const noexcept;

  Refinement(KnotVector old, KnotVector refined, Rows rows)
      : old_(std::move(old)), refined_(std::move(refined)), rows_(std::move(rows)) {}

  KnotVector old_;
  KnotVector refined_;
  Rows rows_;
};

/// `times` copies of u.
/// @throws InvalidShape unless 1 <= times <= degree + 1.
std::vector<double> knot_copies(const KnotVector& knots, double u, int times);

}  // namespace splinecore
