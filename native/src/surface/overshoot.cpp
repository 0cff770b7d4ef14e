#include "overshoot.hpp"

#include <algorithm>
#include <glm/vec3.hpp>

#include "base/length.hpp"
#include "going_on.hpp"

namespace splinecore {

namespace {

glm::dvec3 point_of(const glm::dvec4& p) { return glm::dvec3(p) / p.w; }

/// How far from the start of the domain the mean of the knots is that decide about a row.
double way_to(const KnotVector& across, std::size_t row) {
  const auto degree = static_cast<std::size_t>(across.degree());
  double sum = 0.0;
  for (std::size_t k = 1; k <= degree; ++k) sum += across.knots()[row + k] - across.domain().start;
  return sum / static_cast<double>(degree);
}

}  // namespace

double overshoot(const KnotVector& across, std::span<const std::vector<glm::dvec4>> rows, const std::vector<glm::dvec4>& out,
                 std::size_t count) {
  const std::vector<glm::dvec4>& edge = rows.front();
  const double speed = speed_of(edge, out);
  double largest = 0.0;
  for (std::size_t j = 1; j < count; ++j) {
    const double way = way_to(across, j);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const glm::dvec3 from = point_of(edge[i]);
      const glm::dvec3 slope = (glm::dvec3(out[i]) - out[i].w * from) / edge[i].w;
      largest = std::max(largest, length_of(point_of(rows[j][i]) - from - way * slope) / (way * speed));
    }
  }
  return largest;
}

}  // namespace splinecore
