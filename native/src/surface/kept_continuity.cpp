#include "kept_continuity.hpp"

#include "base/length.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/measure/seam.hpp"

namespace splinecore {

namespace {

glm::dvec3 end_point(const NurbsCurve& curve, bool is_end) {
  return glm::dvec3(is_end ? curve.points().back() : curve.points().front());
}

}  // namespace

void require_continuity(const NurbsPatch& made, Border border, const LoftNeighbor& neighbor, const std::string& name,
                        std::optional<bool> reversed) {
  constexpr double kAngle = 1e-4;
  constexpr double kCurvature = 1e-3;
  constexpr double kApart = 1e-6;
  if (neighbor.continuity < 1) return;
  const NearSpace space(together(made.points(), neighbor.patch.points()));
  const NurbsPatch own = made.with_points(space.enter(made.points()));
  const NurbsPatch other = neighbor.patch.with_points(space.enter(neighbor.patch.points()));
  const SeamContinuity seam = seam_continuity(own, border, other, neighbor.side, kCurvature, {}, reversed);
  if (seam.gap > kApart) {
    const NurbsCurve edge = boundary(other, neighbor.side);
    const bool are_periodic = edge.periodic() && boundary(own, border).periodic();
    if (!are_periodic && (edge.periodic() || distance_of(end_point(edge, false), end_point(edge, true)) <= kApart)) return;
    throw ToleranceNotReached("the patch cannot be made so exactly that it begins along the side of " + name,
                              space.length(kApart), space.length(seam.gap));
  }
  if (seam.angle > kAngle) {
    throw ToleranceNotReached("the patch cannot be made so exactly that it is tangent to " + name, kAngle,
                              seam.angle);
  }
  if (neighbor.continuity < 2 || seam.g != 1) return;
  const double unit = space.length(1.0);
  throw ToleranceNotReached("the patch cannot be made so exactly that it has the curvatures of " + name,
                            kCurvature / unit, seam.curvature_difference / unit);
}

}  // namespace splinecore
