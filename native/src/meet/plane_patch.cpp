#include "plane_patch.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "base/length.hpp"
#include "near_space.hpp"

namespace splinecore {

NurbsPatch plane_about(std::span<const glm::dvec4> of, const Plane& plane) {
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high(-std::numeric_limits<double>::infinity());
  double size = 0.0;
  const glm::dvec4* first = nullptr;
  for (const glm::dvec4& p : of) {
    if (p.w == 0.0) continue;
    if (!first) first = &p;
    size = std::max(size, distance_of(glm::dvec3(p), glm::dvec3(*first)));
    const glm::dvec2 at = point_in(plane, glm::dvec3(p));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  if (!(size > 0.0)) size = std::max({std::abs(low.x), std::abs(low.y), glm::length(plane.origin), 1e-100});
  const KnotVector u = KnotVector::make(1, {low.x - size, low.x - size, high.x + size, high.x + size}, false);
  const KnotVector v = KnotVector::make(1, {low.y - size, low.y - size, high.y + size, high.y + size}, false);
  std::vector<glm::dvec4> points;
  for (const double x : {low.x - size, high.x + size}) {
    for (const double y : {low.y - size, high.y + size}) points.emplace_back(plane.point({x, y}), 1.0);
  }
  return NurbsPatch::make(u, v, std::move(points));
}

}  // namespace splinecore
