#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

namespace splinecore {

/// degree + 1 control points with weights, over [0, 1] (lecture rows S6, S9).
class BezierCurve {
 public:
  /// @throws InvalidShape if there are fewer than 2 or more than kMaxDegree + 1 points, a number
  ///         is not finite, or every weight is zero.
  static BezierCurve make(std::vector<glm::dvec4> points);
  static BezierCurve from_homogeneous(std::span<const glm::dvec4> points);

  BezierCurve with_points(std::vector<glm::dvec4> points) const { return make(std::move(points)); }

  int degree() const noexcept { return form_.degree(); }
  std::span<const glm::dvec4> points() const noexcept { return form_.points(); }

  /// The same curve as NURBS: one span.
  const NurbsCurve& nurbs() const noexcept { return form_; }

  friend bool operator==(const BezierCurve&, const BezierCurve&) noexcept = default;

 private:
  explicit BezierCurve(NurbsCurve form) : form_(std::move(form)) {}
  NurbsCurve form_;
};

/// The parts before and after u, each over [0, 1] (de Casteljau).
/// @throws InvalidShape unless 0 < u < 1.
std::pair<BezierCurve, BezierCurve> split(const BezierCurve& curve, double u);

BezierCurve reversed(const BezierCurve& curve);

}  // namespace splinecore
