#include "region_plane.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>

#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/plane.hpp"

namespace splinecore {

std::vector<glm::dvec4> points_of(std::span<const NurbsCurve> curves) {
  std::vector<glm::dvec4> points;
  for (const NurbsCurve& curve : curves) std::ranges::copy(curve.points(), std::back_inserter(points));
  return points;
}

double region_tolerance(std::span<const NurbsCurve> curves, std::optional<double> tolerance) {
  const NearSpace space(points_of(curves));
  return space.length(place_tolerance(space, tolerance));
}

glm::dvec3 common_normal(std::span<const NurbsCurve> curves, double tolerance) {
  constexpr double kUpright = 1e-12;
  std::vector<glm::dvec3> points;
  for (const glm::dvec4& p : points_of(curves)) {
    if (p.w != 0.0) points.emplace_back(p);
  }
  const Plane plane = plane_of(points, tolerance);
  const glm::dvec3 normal = glm::cross(plane.x_axis, plane.y_axis);
  for (const int axis : {2, 1, 0}) {
    if (std::abs(normal[axis]) > kUpright) return normal[axis] > 0.0 ? normal : -normal;
  }
  return normal;
}

void require_one_plane(std::span<const NurbsCurve> curves, const glm::dvec3& normal, double tolerance) {
  if (curves.empty()) return;
  const auto is_point = [](const glm::dvec4& p) { return p.w != 0.0; };
  const glm::dvec3 start(*std::ranges::find_if(curves[0].points(), is_point));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const glm::dvec4& p : curves[i].points()) {
      const double height = std::abs(glm::dot(is_point(p) ? glm::dvec3(p) - start : glm::dvec3(p), normal));
      if (height <= tolerance) continue;
      throw InvalidShape("curves" + index_text(i) + " is not in the plane: it leaves it by " + text_of(height) +
                         ", more than the tolerance " + text_of(tolerance));
    }
  }
}

}  // namespace splinecore
