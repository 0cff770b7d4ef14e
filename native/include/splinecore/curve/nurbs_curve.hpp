#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/base/lazy.hpp"
#include "splinecore/basis/knot_vector.hpp"

namespace splinecore {

class BoxedPieces;
class CurveTables;

/// n control points with weights on a knot vector of any degree, plain or periodic.
///
/// A point is (x, y, z, w) as it was given. w = 0 makes (x, y, z) a direction, a point at
/// infinity, and a negative w is allowed: both are shapes that the conics need.
/// Immutable and valid, because make() is the only way in (lecture rows S11, S15).
class NurbsCurve {
 public:
  /// @throws InvalidShape if the degree is below 1, counts disagree, a number is not finite,
  ///         every w is zero, or the knots are not a valid KnotVector with a domain.
  static NurbsCurve make(KnotVector knots, std::vector<glm::dvec4> points);
  static NurbsCurve make(int degree, std::vector<double> knots, std::vector<glm::dvec4> points,
                         bool periodic = false);

  /// From homogeneous points (wx, wy, wz, w).
  static NurbsCurve from_homogeneous(KnotVector knots, std::span<const glm::dvec4> points);

  /// Other points on the same knots.
  NurbsCurve with_points(std::vector<glm::dvec4> points) const { return make(knots_, std::move(points)); }

  int degree() const noexcept { return knots_.degree(); }
  bool periodic() const noexcept { return knots_.periodic(); }
  bool rational() const noexcept { return rational_; }
  const KnotVector& knot_vector() const noexcept { return knots_; }
  Interval domain() const { return knots_.domain(); }
  std::span<const glm::dvec4> points() const noexcept { return points_; }

  /// Homogeneous points, unrolled where periodic: what the weights of a Stencil apply to. Weights, and directions,
  /// are divided by 2^weight_exponent().
  std::span<const glm::dvec4> homogeneous_points() const noexcept {
    return homogeneous_.empty() ? std::span(points_) : std::span(homogeneous_);
  }
  int weight_exponent() const noexcept { return weight_exponent_; }

  /// What evaluation computes of its spans, each when it is first asked for; shared by copies.
  CurveTables& tables() const noexcept { return *tables_; }

  /// Its pieces in a tree of boxes, for those who search them; shared by copies.
  Lazy<BoxedPieces>& boxed_pieces() const noexcept { return *boxed_pieces_; }

  friend bool operator==(const NurbsCurve& a, const NurbsCurve& b) noexcept {
    return a.knots_ == b.knots_ && a.points_ == b.points_;
  }

 private:
  NurbsCurve(KnotVector knots, std::vector<glm::dvec4> points);

  KnotVector knots_;
  std::vector<glm::dvec4> points_;
  bool rational_ = false;
  int weight_exponent_ = 0;
  std::vector<glm::dvec4> homogeneous_;  ///< none where they are the points as given
  std::shared_ptr<CurveTables> tables_;
  std::shared_ptr<Lazy<BoxedPieces>> boxed_pieces_ = std::make_shared<Lazy<BoxedPieces>>();
};

/// The same curve with these parameters added to its knots, each as often as it occurs.
/// Untouched control points are copied bit for bit (Boehm 1980, Goldman's blossom form; S15).
/// A periodic curve takes any, modulo its period.
/// @throws InvalidShape if one is outside the domain of a plain curve or its multiplicity would pass degree + 1.
NurbsCurve refine(const NurbsCurve& curve, std::span<const double> inserted);

/// refine() with `times` copies of one parameter.
NurbsCurve insert_knot(const NurbsCurve& curve, double u, int times = 1);

/// The pieces before and after u, each on its part of the domain.
/// @throws InvalidShape if u is not strictly inside the domain, the curve is periodic, or a piece
///         would lie at infinity altogether.
std::pair<NurbsCurve, NurbsCurve> split(const NurbsCurve& curve, double u);

/// A periodic curve cut at u: a plain one over one period, clamped at both ends.
NurbsCurve opened(const NurbsCurve& curve, double u);

/// The same curve as a plain one: knots and points of a periodic curve repeated as far as the
/// domain needs them. A plain curve is returned as it is.
NurbsCurve unrolled(const NurbsCurve& curve);

/// The same points in the opposite direction, over the same domain; where rounding would spoil short spans far from
/// zero, over [-end, -start].
NurbsCurve reversed(const NurbsCurve& curve);

/// The homogeneous Bezier points of the pieces on all spans of the knot vector, row after row.
void bezier_points(const NurbsCurve& curve, std::span<glm::dvec4> out);

/// The intervals of the domain, in order, on which the curve is finite and in one piece: it is
/// cut where the weight is zero and at knots of multiplicity degree + 1. Ends may be at infinity.
std::vector<Interval> pieces(const NurbsCurve& curve);

/// Whether the weight at u is zero, up to rounding.
bool is_at_infinity(const NurbsCurve& curve, double u, Side side);

}  // namespace splinecore
