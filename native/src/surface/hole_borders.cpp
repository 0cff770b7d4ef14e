#include "hole_borders.hpp"

#include <algorithm>
#include <cstddef>

#include "fit/row_spline.hpp"
#include "greville.hpp"
#include "raised_knots.hpp"

namespace splinecore {

namespace {

/// D of a side, nearly.
NurbsCurve across_curve(const HoleSide& side) {
  constexpr int kDegree = 7;
  const KnotVector knots = raised_knots(side.knots(), std::max(kDegree, side.knots().degree()), 1);
  const auto numbers = [](const glm::dvec3& d) { return std::vector<double>{d.x, d.y, d.z}; };
  RowConditions given{interpolation_places_between_slopes(knots), {}, {numbers(side.jet(false).first[1])}, {numbers(side.jet(true).first[1])}};
  for (const glm::dvec3& d : side.across(given.parameters, 1)) given.rows.push_back(numbers(d));
  const RowSpline spline = spline_through(given, knots.degree(), Closing::open, {knots.knots().begin(), knots.knots().end()});
  std::vector<glm::dvec4> vectors;
  for (int i = 0; i < knots.count(); ++i) {
    const double* const d = &spline.controls[static_cast<std::size_t>(3 * i)];
    vectors.emplace_back(d[0], d[1], d[2], 1.0);
  }
  return NurbsCurve::make(knots, std::move(vectors));
}

LeftBorder border_of(const HoleSide& side) {
  return {side.curve(), side.continuity() > 0 ? std::optional(across_curve(side)) : std::nullopt};
}

}  // namespace

BorderPairs hole_borders(const Hole& hole) {
  const auto& sides = hole.sides;
  return borders_around({border_of(sides[0]), border_of(sides[1]), border_of(sides[2]), border_of(sides[3])});
}

}  // namespace splinecore
