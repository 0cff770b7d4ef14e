#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "splinecore/patch/evaluate.hpp"
#include "splinecore/patch/isocurve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Within this part of the way two places along a seam are the same.
inline constexpr double kSameShare = 1e-12;

/// A place along a seam, by its part of the way; at a knot what comes after it (Side::right) or before.
struct SeamPlace {
  double share;
  Side side;
};

/// What of a patch is looked at.
enum class SeamDepth { normals, curvatures };

/// What a patch is at a place of its side; NaN where it is at infinity, and 0 of what lies deeper than is looked.
struct SeamJet {
  glm::dvec3 point;
  glm::dvec3 along;
  glm::dvec3 across;
  glm::dvec3 second_across;
  glm::dvec3 normal;  ///< across times along; NaN where there is none
  double curvature;   ///< at right angles to the seam, towards the normal
  bool is_regular;    ///< across and along are not parallel
  double rise;        ///< of across over along
};

/// One of two patches, near the origin and of size one or so, as seen along its side.
class Flank {
 public:
  enum class Role { first, second };

  /// @param role  the way across leads out of the first patch and into the second
  /// @param is_reversed  along the seam its parameter falls
  Flank(NurbsPatch patch, Border side, Role role, bool is_reversed);

  int degree_along() const { return along().degree(); }

  /// The knots inside the side, by their parts of the way.
  std::vector<double> inner_knots() const;

  /// The largest weight by the least one, of the control points that the span at a place depends on.
  double weight_spread(double share) const;

  std::vector<SeamJet> jets(std::span<const SeamPlace> places, SeamDepth depth) const;

  /// How far it is from a place to the end of its span.
  double room(const SeamPlace& place) const;

  /// How far rounding may move a point and the first two derivatives across.
  /// @param pace  the largest derivative along
  std::array<double, 3> rounding(double pace) const;

 private:
  const KnotVector& along() const { return patch_.knot_vector(axis_of(side_) == Axis::u ? Axis::v : Axis::u); }
  const KnotVector& across() const { return patch_.knot_vector(axis_of(side_)); }
  double edge() const { return is_at_end(side_) ? across().domain().end : across().domain().start; }
  Side inward() const { return is_at_end(side_) ? Side::left : Side::right; }
  /// What turns the patch's normal into across times along.
  double facing() const { return (axis_of(side_) == Axis::u ? 1.0 : -1.0) * turn_ * way_; }
  double share_of(double knot) const;
  double parameter_at(double share) const;
  void add(std::span<const SeamPlace> places, Side side, SeamDepth depth, std::span<SeamJet> jets) const;

  /// All of the depth of normals.
  SeamJet jet_of(const glm::dvec3& point, const glm::dvec3& by_u, const glm::dvec3& by_v, const glm::dvec3& normal) const;

  /// The start of a span along, and its part of the way.
  struct SharedKnot {
    double share;
    double knot;
  };

  NurbsPatch patch_;
  Border side_;
  std::vector<SharedKnot> knots_;  ///< in the order of the way
  double way_;         ///< -1 where the parameter across falls on the way
  double turn_;        ///< -1 where that along does
  double negligible_;  ///< size below which the product of the first derivatives is rounding
};

}  // namespace splinecore
#pragma GCC visibility pop
