#include "splinecore/build/contour.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "base/length.hpp"
#include "base/require.hpp"
#include "curve_ends.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/curve/ends.hpp"

namespace splinecore {

namespace {

NurbsCurve arc_between(const glm::dvec3& a, const glm::dvec3& b, double bulge, const glm::dvec3& normal) {
  const glm::dvec3 along = (b - a) / distance_of(a, b);
  const glm::dvec3 left = glm::cross(normal, along);
  const double length = glm::length(left);
  constexpr double kAlong = 0x1p-40;
  if (!(length > kAlong)) throw InvalidShape("the normal is along the chord of an arc");
  // The tangent leaves the chord by half the arc's angle, to its right where the arc goes to the left.
  const double half = 2.0 * std::atan(bulge);
  return arc_from_tangent(a, std::cos(half) * along - std::sin(half) * (left / length), b);
}

}  // namespace

NurbsCurve contour(std::span<const glm::dvec3> points, std::span<const double> bulges, bool closed,
                   const glm::dvec3& normal) {
  require_finite(points, "points");
  if (points.size() < 2) throw InvalidShape("a contour needs two points or more");
  const std::size_t count = closed ? points.size() : points.size() - 1;
  if (!bulges.empty() && bulges.size() != count) {
    throw InvalidShape("bulges has " + std::to_string(bulges.size()) + " values for " + std::to_string(count) + " parts");
  }
  std::vector<NurbsCurve> made;
  const double length = glm::length(normal);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3& a = points[i];
    const glm::dvec3& b = points[(i + 1) % points.size()];
    const double bulge = bulges.empty() ? 0.0 : bulges[i];
    if (!std::isfinite(bulge)) throw InvalidShape("bulges[" + std::to_string(i) + "] is not a finite number");
    if (a == b) throw InvalidShape("point " + std::to_string(i) + " and the next one coincide: a segment has no length");
    if (bulge != 0.0 && !(length > 0.0 && std::isfinite(length))) {
      throw InvalidShape("the normal is zero or not finite");
    }
    made.push_back(bulge == 0.0 ? line_between(a, b) : arc_between(a, b, bulge, normal / length));
  }
  const Interval first{0.0, distance_of(points[0], points[1])};
  made.front() = with_domain(made.front(), first);
  return closed ? with_one_end(chained(made)) : chained(made);
}

}  // namespace splinecore
