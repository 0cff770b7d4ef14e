#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "splinecore/base/interval.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Coordinates in the plane of a curve.
class PlaneView {
 public:
  explicit PlaneView(const glm::dvec3& normal);
  glm::dvec2 seen(const glm::dvec3& p) const;

 private:
  glm::dvec3 x_;
  glm::dvec3 y_;
};

/// Bounds of a part of a curve's piece in its plane, of its tangents, and of what lies beside it at a distance to the left, by its
/// control points.
class OffsetBox {
 public:
  /// @param points  homogeneous, in the plane
  OffsetBox(std::vector<glm::dvec3> points, const Interval& part, double side);

  const Interval& part() const { return part_; }
  /// Whether tangents are known to lie within a right angle, and all points to be finite.
  bool is_bounded() const { return is_finite_ && half_angle_ < kUnknown; }
  double half_angle() const { return half_angle_; }
  const glm::dvec2& way() const { return way_; }
  glm::dvec2 middle() const { return middle_; }

  /// How large what lies beside it is at most, about.
  double size() const;

  /// Between which numbers the offset lies along a unit direction.
  Interval along(const glm::dvec2& direction) const;

  std::pair<OffsetBox, OffsetBox> halves() const;

  static constexpr double kUnknown = 4.0;

 private:
  void find_tangents(const std::vector<glm::dvec2>& polygon);

  std::vector<glm::dvec3> points_;
  Interval part_;
  double side_;
  bool is_finite_;
  glm::dvec2 way_{1.0, 0.0};
  glm::dvec2 middle_{0.0};  ///< of what lies beside it
  double half_angle_ = kUnknown;
};

/// Of every span of a curve.
std::vector<OffsetBox> offset_boxes(const NurbsCurve& curve, const PlaneView& view, double side);

/// Whether two offsets are seen to lie apart.
bool are_apart(const OffsetBox& a, const OffsetBox& b);

/// Whether an offset is seen to lie farther from a place than so much.
bool is_beyond(const OffsetBox& box, const glm::dvec2& place, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
