#include "common_origin.hpp"

#include <algorithm>
#include <array>

namespace splinecore {

glm::dvec3 common_origin(std::span<const glm::dvec4> a, std::span<const glm::dvec4> b) {
  glm::dvec3 origin(0.0);
  const auto first = std::ranges::find_if(a, [](const glm::dvec4& point) { return point.w != 0.0; });
  if (first == a.end()) return origin;
  for (int c = 0; c < 3; ++c) {
    const double at = (*first)[c];
    const std::array<double, 2> range{std::min(0.5 * at, 2.0 * at), std::max(0.5 * at, 2.0 * at)};
    const auto is_exact = [&](const glm::dvec4& point) {
      return point.w == 0.0 || (range[0] <= point[c] && point[c] <= range[1]);
    };
    if (std::ranges::all_of(a, is_exact) && std::ranges::all_of(b, is_exact)) origin[c] = at;
  }
  return origin;
}

std::vector<glm::dvec4> from_origin(std::span<const glm::dvec4> points, const glm::dvec3& origin) {
  std::vector<glm::dvec4> moved(points.begin(), points.end());
  for (glm::dvec4& point : moved) {
    if (point.w != 0.0) point -= glm::dvec4(origin, 0.0);
  }
  return moved;
}

}  // namespace splinecore
