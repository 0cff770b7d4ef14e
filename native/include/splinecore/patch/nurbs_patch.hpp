#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/base/axis.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/base/lazy.hpp"
#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

class BoxedPieces;
struct NormalFacts;

/// A net of control points with weights on two knot vectors (lecture row S20).
///
/// Points lie row after row: point (i, j) is points()[i * count_v + j], with i along u.
class NurbsPatch {
 public:
  /// @throws InvalidShape if a degree is below 1, counts disagree, a number is not finite, or
  ///         every w is zero.
  static NurbsPatch make(KnotVector knots_u, KnotVector knots_v, std::vector<glm::dvec4> points);
  static NurbsPatch from_homogeneous(KnotVector knots_u, KnotVector knots_v,
                                     std::span<const glm::dvec4> points);

  NurbsPatch with_points(std::vector<glm::dvec4> points) const {
    return make(knots_u_, knots_v_, std::move(points));
  }

  const KnotVector& knot_vector(Axis axis) const noexcept { return axis == Axis::u ? knots_u_ : knots_v_; }
  int count(Axis axis) const noexcept { return knot_vector(axis).count(); }
  bool rational() const noexcept { return rational_; }
  std::span<const glm::dvec4> points() const noexcept { return points_; }

  /// Homogeneous points, unrolled in both directions, row after row. Weights, and directions, are divided by
  /// 2^weight_exponent().
  std::span<const glm::dvec4> homogeneous_points() const noexcept {
    return homogeneous_.empty() ? std::span(points_) : std::span(homogeneous_);
  }
  int weight_exponent() const noexcept { return weight_exponent_; }

  /// Its pieces in a tree of boxes, for those who search them; shared by copies.
  Lazy<BoxedPieces>& boxed_pieces() const noexcept { return found_->boxed_pieces; }

  /// What all its normals need to know; shared by copies.
  Lazy<NormalFacts>& normal_facts() const noexcept { return found_->normal_facts; }

  friend bool operator==(const NurbsPatch& a, const NurbsPatch& b) noexcept {
    return a.knots_u_ == b.knots_u_ && a.knots_v_ == b.knots_v_ && a.points_ == b.points_;
  }

 private:
  NurbsPatch(KnotVector knots_u, KnotVector knots_v, std::vector<glm::dvec4> points);

  KnotVector knots_u_;
  KnotVector knots_v_;
  std::vector<glm::dvec4> points_;
  bool rational_ = false;
  int weight_exponent_ = 0;
  std::vector<glm::dvec4> homogeneous_;  ///< none where they are the points as given
  struct Found {
    Lazy<BoxedPieces> boxed_pieces;
    Lazy<NormalFacts> normal_facts;
  };
  std::shared_ptr<Found> found_ = std::make_shared<Found>();
};

/// refine() of a curve, in one direction.
NurbsPatch refine(const NurbsPatch& patch, Axis axis, std::span<const double> inserted);
NurbsPatch insert_knot(const NurbsPatch& patch, Axis axis, double u, int times = 1);

/// The parts before and after a parameter of one direction.
std::pair<NurbsPatch, NurbsPatch> split(const NurbsPatch& patch, Axis axis, double u);

NurbsPatch reversed(const NurbsPatch& patch, Axis axis);

/// A periodic direction cut at a parameter: plain and clamped there.
NurbsPatch opened(const NurbsPatch& patch, Axis axis, double u);

/// u and v exchanged: the same points, normals on the other side.
NurbsPatch swapped(const NurbsPatch& patch);

/// The same surface with plain knot vectors.
NurbsPatch unrolled(const NurbsPatch& patch);

}  // namespace splinecore
