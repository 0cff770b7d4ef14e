#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// What a sharp corner of an offset adds to an arc: the four-sided face from the corner of the curve to its offsets and to where
/// their tangents meet.
struct SharpTip {
  glm::dvec3 corner;
  glm::dvec3 start;
  glm::dvec3 tip;
  glm::dvec3 end;
};

/// The tips of an offset, each without what the curve cuts off from its corner.
class SharpTips {
 public:
  /// @param curve  that is offset, in the same space
  /// @param slack  a length: places so near to the border of a tip are on it
  SharpTips(const NurbsCurve& curve, std::vector<SharpTip> tips, double slack);

  /// Whether a place is inside of a tip.
  bool cover(const glm::dvec3& place) const;

  /// Whether a place is inside of a tip or on its border.
  bool hold(const glm::dvec3& place) const;

 private:
  /// Polygons about parts of a tip.
  using Parts = std::vector<std::vector<glm::dvec3>>;

  bool any(const glm::dvec3& place, double inside) const;

  std::vector<SharpTip> tips_;
  std::vector<Parts> cut_off_;  ///< from each
  double slack_;
};

}  // namespace splinecore
#pragma GCC visibility pop
