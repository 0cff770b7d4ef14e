#include "closed_curve.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>

#include "finite_weights.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "unit_direction.hpp"

namespace splinecore {

ClosedCurve closed_curve(const NurbsCurve& curve, const glm::dvec3& normal, const Placement& placement) {
  constexpr double kClosed = 1e-9;
  const View view(unit_direction(normal, "normal"));
  require_finite_points(curve, curve.domain());
  const std::size_t count = pieces(curve).size();
  if (count > 1) throw InvalidShape("the curve is not closed: it is in " + std::to_string(count) + " pieces");
  NearCurve near = near_origin(curve, placement);
  std::array<glm::dvec3, 2> ends;
  const Interval domain = near.curve.domain();
  evaluate(near.curve, {&domain.start, 1}, std::span(&ends[0].x, 3), {.side = Side::right});
  evaluate(near.curve, {&domain.end, 1}, std::span(&ends[1].x, 3), {.side = Side::left});
  const double apart = glm::distance(ends[0], ends[1]);
  const double size = extent(near.curve.points());
  if (apart > kClosed * size) {
    throw InvalidShape("the curve is not closed: its ends are apart by " + text_of(apart / size) + " of its size");
  }
  return {std::move(near), view, view.seen(ends[0]), view.seen(ends[1])};
}

}  // namespace splinecore
