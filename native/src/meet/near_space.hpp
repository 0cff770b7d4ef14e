#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A factor as a product of two, for it may be no number.
struct TwoFactors {
  double first = 1.0;
  double second = 1.0;

  glm::dvec3 times(const glm::dvec3& p) const noexcept { return p * first * second; }
  double times(double x) const noexcept { return x * first * second; }
};

/// A point as the search sees it, and whether it was drawn nearer.
struct NearPoint {
  glm::dvec3 at;
  bool moved;
};

/// Coordinates about the middle of a shape's finite control points in which these lie within about 1: no digit is lost
/// far from the origin, and no square leaves the numbers.
class NearSpace {
 public:
  explicit NearSpace(std::span<const glm::dvec4> points);

  /// The same, but that control points reach just 1 from their middle, so that shapes that are moved and scaled are the same
  /// there, up to rounding.
  NearSpace of_size_one() const noexcept;

  /// Of a point farther out than `far` one on the way to it. From 2^27 on distances to the shape then differ, from each
  /// other, by less than their rounding, from 2^60 on directions too.
  NearPoint enter(const glm::dvec3& point, double far = 0x1p27) const noexcept;
  glm::dvec3 leave(const glm::dvec3& near) const noexcept {
    return out_of_outer_.times(out_of_inner_.times(near) + origin_);
  }

  /// Control points with their weights, of which directions have none.
  std::vector<glm::dvec4> enter(std::span<const glm::dvec4> points) const;
  glm::dvec4 leave(const glm::dvec4& near) const noexcept {
    if (near.w == 0.0) return glm::dvec4(glm::dvec3(near) * length(1.0), 0.0);
    return glm::dvec4(leave(glm::dvec3(near)), near.w);
  }
  std::vector<glm::dvec4> leave(std::span<const glm::dvec4> near) const;

  /// A length out there.
  double length(double near) const noexcept { return out_of_outer_.times(out_of_inner_.times(near)); }

  /// How far the shape's control points reach there from the middle of them all, which no motion changes.
  double size() const noexcept { return size_; }

  /// How much of a coordinate may be rounding of those given.
  double rounding() const noexcept { return rounding_; }

  /// Homogeneous points from those given and their homogeneous form, as a shape has both.
  /// @param width  points of a row, and `unrolled_width` of one of the unrolled net; homogeneous points are unrolled
  std::vector<glm::dvec4> homogeneous(std::span<const glm::dvec4> given, std::span<const glm::dvec4> homogeneous,
                                      std::size_t width, std::size_t unrolled_width) const;

 private:
  double size_of(std::span<const glm::dvec4> points) const;

  glm::dvec3 origin_{0.0};
  int outer_ = 0;  ///< coordinates are divided by 2^outer_, the origin is subtracted, and the rest divided by 2^inner_
  int inner_ = 0;
  double rounding_ = 0.0;
  double size_ = 0.0;
  TwoFactors into_outer_, into_inner_, out_of_outer_, out_of_inner_;
};

/// The points of two shapes that share a space.
std::vector<glm::dvec4> together(std::span<const glm::dvec4> a, std::span<const glm::dvec4> b);

/// The tolerance for places of a shape where none is given: 2^-33 of its size.
double default_place_tolerance(std::span<const glm::dvec4> points);

/// What is one lies so near, of a tolerance there: 1/64 of it, or what rounding of the coordinates leaves.
double distance_of_one(double tolerance, double rounding) noexcept;

/// A tolerance there for places of shapes, by default 2^-33 of their size; no smaller one than rounding leaves.
/// @throws InvalidShape unless it is 0 or more.
double place_tolerance(const NearSpace& space, std::optional<double> tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
