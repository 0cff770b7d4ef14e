#include "splinecore/fit/interpolate.hpp"

#include <algorithm>
#include <cmath>

#include "splinecore/base/pause.hpp"
#include "system.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec4> solved(const KnotVector& knots, System system) {
  solve(knots, system.rows, system.right, 3);
  std::vector<glm::dvec4> points(system.rows.count());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const row = system.right.data() + 3 * i;
    points[i] = {row[0], row[1], row[2], 1.0};
    require_control_point(glm::dvec3(points[i]));
  }
  return points;
}

/// Of the curve from its points.
double largest_distance(const NurbsCurve& curve, const BandedRows& rows, std::span<const Condition> conditions) {
  const std::span<const glm::dvec4> points = curve.points();
  double largest = 0.0;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].order > 0) continue;
    breathe(4 * rows.width);
    const auto row = rows.row(i);
    glm::dvec3 left = conditions[i].value;
    std::size_t at = static_cast<std::size_t>(rows.first[i]) % points.size();
    for (const double weight : row) {
      left -= weight * glm::dvec3(points[at]);
      if (++at == points.size()) at = 0;
    }
    largest = std::max(largest, std::hypot(left.x, left.y, left.z));
  }
  return largest;
}

}  // namespace

Approximation<NurbsCurve> interpolate(std::span<const glm::dvec3> points, std::span<const double> parameters,
                                      const InterpolationOptions& options) {
  const std::vector<Condition> conditions = conditions_of(points, parameters, options);
  const KnotVector knots = knots_for(conditions, parameters, options);
  const System system = system_of(knots, conditions);
  NurbsCurve curve = NurbsCurve::make(knots, solved(knots, system));
  const double error = largest_distance(curve, system.rows, conditions);
  require_passing(error, largest_coordinate(points));
  return {std::move(curve), error};
}

}  // namespace splinecore
