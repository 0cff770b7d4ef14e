#include "seam_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "patch/lines.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

struct PlaceOfSide {
  double distance;
  double rise;  ///< of half the square of that
};

PlaceOfSide place_at(const NurbsCurve& side, double u, const glm::dvec3& point) {
  std::array<glm::dvec3, 2> jet;
  derivatives(side, std::span(&u, 1), 1, std::span(&jet[0].x, 6), {.at_infinity = AtInfinity::nan});
  const glm::dvec3 away = jet[0] - point;
  return {glm::length(away), glm::dot(away, jet[1])};
}

/// The parameter at which a closed side is nearest to a point, from places that are close in every span.
double nearest_parameter(const NurbsCurve& side, const glm::dvec3& point) {
  const KnotVector& knots = side.knot_vector();
  const int count = 4 * side.degree() + 4;
  std::vector<double> places;
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const Interval span = knots.span_interval(i);
    for (int k = 0; k < count; ++k) places.push_back(span.start + span.length() * k / count);
  }
  places.push_back(knots.domain().end);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double distance = place_at(side, places[i], point).distance;
    if (!(distance < least)) continue;
    least = distance;
    best = i;
  }
  double low = places[best > 0 ? best - 1 : 0];
  double high = places[std::min(best + 1, places.size() - 1)];
  constexpr int kHalvings = 60;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (place_at(side, middle, point).rise < 0.0 ? low : high) = middle;
  }
  const double refined = 0.5 * (low + high);
  return place_at(side, refined, point).distance <= least ? refined : places[best];
}

}  // namespace

NurbsPatch begun_beside(const NurbsPatch& first, Border side_a, const NurbsPatch& second, Border side_b) {
  constexpr double kSame = 0x1p-36;
  constexpr double kNear = 0x1p-20;
  const NurbsCurve of_a = boundary(first, side_a);
  const NurbsCurve of_b = boundary(second, side_b);
  if (!of_a.periodic() || !of_b.periodic()) return second;
  glm::dvec3 start;
  const double at_start = of_a.domain().start;
  evaluate(of_a, std::span(&at_start, 1), std::span(&start.x, 3), {.at_infinity = AtInfinity::nan});
  const double size = extent(of_a.points());
  const Interval domain = of_b.domain();
  if (!(place_at(of_b, domain.start, start).distance > kSame * size)) return second;
  double u = nearest_parameter(of_b, start);
  if (!(place_at(of_b, u, start).distance <= kNear * size)) return second;
  for (const double knot : of_b.knot_vector().knots()) {
    if (std::abs(knot - u) <= kSame * domain.length()) u = knot;
  }
  if (!(u > domain.start && u < domain.end)) return second;
  const Axis axis = axis_of(side_b) == Axis::u ? Axis::v : Axis::u;
  return along(second, axis, [&](const NurbsCurve& line) { return with_seam_at(line, u); });
}

}  // namespace splinecore
