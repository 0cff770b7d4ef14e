#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/patch/nurbs_patch.hpp"

namespace splinecore {

/// A net of (degree_u + 1) x (degree_v + 1) control points over [0, 1]² (lecture row S19).
class BezierPatch {
 public:
  /// @throws InvalidShape unless there are count_u x count_v points, both counts from 2 to
  ///         kMaxDegree + 1, all numbers finite and not every weight zero.
  static BezierPatch make(int count_u, int count_v, std::vector<glm::dvec4> points);

  /// The patch with as many other points, on the knot vectors that this one has. @throws InvalidShape as make().
  BezierPatch with_points(std::vector<glm::dvec4> points) const {
    return BezierPatch(form_.with_points(std::move(points)));
  }

  int degree(Axis axis) const noexcept { return form_.knot_vector(axis).degree(); }
  int count(Axis axis) const noexcept { return form_.count(axis); }
  std::span<const glm::dvec4> points() const noexcept { return form_.points(); }

  /// The same patch as NURBS: one span in each direction.
  const NurbsPatch& nurbs() const noexcept { return form_; }

  friend bool operator==(const BezierPatch&, const BezierPatch&) noexcept = default;

 private:
  explicit BezierPatch(NurbsPatch form) : form_(std::move(form)) {}
  NurbsPatch form_;
};

/// The parts before and after a parameter of one direction, each over [0, 1]².
std::pair<BezierPatch, BezierPatch> split(const BezierPatch& patch, Axis axis, double u);

BezierPatch reversed(const BezierPatch& patch, Axis axis);
BezierPatch swapped(const BezierPatch& patch);

}  // namespace splinecore
