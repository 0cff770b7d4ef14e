#include "gathered_poles.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/length.hpp"
#include "lines.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

bool ends_in_its_net(const KnotVector& knots, bool is_end) {
  return !knots.periodic() && multiplicity(knots, is_end ? knots.domain().end : knots.domain().start) > knots.degree();
}

}  // namespace

GatheredPoles with_gathered_poles(const NurbsPatch& patch, double distance) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  double moved = 0.0;
  for (const Border side : {Border::u_start, Border::u_end, Border::v_start, Border::v_end}) {
    if (!ends_in_its_net(patch.knot_vector(axis_of(side)), is_at_end(side))) continue;
    const Lines lines = lines_of(patch, axis_of(side));
    const auto number = [&](std::size_t line) { return lines.at(line, is_at_end(side) ? lines.size - 1 : 0); };
    glm::dvec3 middle(0.0);
    bool is_finite = true;
    for (std::size_t line = 0; line < lines.count; ++line) {
      middle += glm::dvec3(points[number(line)]) / static_cast<double>(lines.count);
      is_finite = is_finite && points[number(line)].w != 0.0;
    }
    double farthest = 0.0;
    for (std::size_t line = 0; line < lines.count; ++line) {
      farthest = std::max(farthest, distance_of(middle, glm::dvec3(points[number(line)])));
    }
    if (!is_finite || farthest > distance) continue;
    for (std::size_t line = 0; line < lines.count; ++line) points[number(line)] = glm::dvec4(middle, points[number(line)].w);
    moved = std::max(moved, farthest);
  }
  return {moved > 0.0 ? patch.with_points(std::move(points)) : patch, moved};
}

}  // namespace splinecore
