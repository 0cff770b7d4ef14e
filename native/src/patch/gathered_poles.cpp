#include "gathered_poles.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "base/positive_weights.hpp"
#include "clamped_end.hpp"
#include "lines.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

/// The points of a side, in a net.
std::vector<std::size_t> numbers_along(const NurbsPatch& patch, Border side) {
  const Lines lines = lines_of(patch, axis_of(side));
  std::vector<std::size_t> found;
  for (std::size_t line = 0; line < lines.count; ++line) found.push_back(lines.at(line, is_at_end(side) ? lines.size - 1 : 0));
  return found;
}

}  // namespace

GatheredPoles with_gathered_poles(const NurbsPatch& patch, double distance) {
  if (!have_positive_weights(patch.points())) return {patch, 0.0};
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  double moved = 0.0;
  for (const Border side : {Border::u_start, Border::u_end, Border::v_start, Border::v_end}) {
    if (!is_clamped_at(patch.knot_vector(axis_of(side)), is_at_end(side))) continue;
    const std::vector<std::size_t> numbers = numbers_along(patch, side);
    const glm::dvec3 first(points[numbers.front()]);
    glm::dvec3 middle = first;
    for (const std::size_t i : numbers) middle += (glm::dvec3(points[i]) - first) / static_cast<double>(numbers.size());
    double farthest = 0.0;
    for (const std::size_t i : numbers) farthest = std::max(farthest, distance_of(middle, glm::dvec3(points[i])));
    if (!(farthest > 0.0) || farthest > distance) continue;
    for (const std::size_t i : numbers) points[i] = glm::dvec4(middle, points[i].w);
    moved += farthest;
  }
  return {moved > 0.0 ? patch.with_points(std::move(points)) : patch, moved};
}

}  // namespace splinecore
