#include "splinecore/surface/coons.hpp"

#include <string>
#include <vector>

#include "boolean_sum.hpp"
#include "border_loop.hpp"
#include "meet/near_space.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/sweeps.hpp"
#include "splinecore/curve/compatible.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/patch/isocurve.hpp"

namespace splinecore {

namespace {

NurbsCurve over_unit(const NurbsCurve& curve) { return with_domain(curve, {0.0, 1.0}); }

/// A side that is a point, run through from 0 to 1.
NurbsCurve standing(const glm::dvec3& point) {
  return NurbsCurve::make(KnotVector::bezier(1), {glm::dvec4(point, 1.0), glm::dvec4(point, 1.0)});
}

NurbsPatch bilinear(const NurbsCurve& low, const NurbsCurve& high) {
  return NurbsPatch::make(KnotVector::bezier(1), KnotVector::bezier(1),
                          {low.points().front(), high.points().front(), low.points().back(), high.points().back()});
}

/// The patch with sides that are these in every bit where that is so but for rounding.
NurbsPatch with_sides(const NurbsPatch& patch, const NurbsCurve& low, const NurbsCurve& high, const NurbsCurve& left,
                      const NurbsCurve& right) {
  std::vector<glm::dvec4> points(patch.points().begin(), patch.points().end());
  const auto count_u = static_cast<std::size_t>(patch.count(Axis::u));
  const auto count_v = static_cast<std::size_t>(patch.count(Axis::v));
  const NurbsCurve of_u = boundary(patch, Border::v_start);
  const NurbsCurve of_v = boundary(patch, Border::u_start);
  const auto first = compatible(of_u, low).second;
  const auto second = compatible(of_u, high).second;
  const auto third = compatible(of_v, left).second;
  const auto fourth = compatible(of_v, right).second;
  for (std::size_t j = 0; j < count_v; ++j) {
    points[j] = third.points()[j];
    points[(count_u - 1) * count_v + j] = fourth.points()[j];
  }
  for (std::size_t i = 0; i < count_u; ++i) {
    points[i * count_v] = first.points()[i];
    points[i * count_v + count_v - 1] = second.points()[i];
  }
  return patch.with_points(std::move(points));
}

}  // namespace

Approximation<NurbsPatch> coons(std::span<const NurbsCurve> sides, std::optional<double> tolerance) {
  if (sides.size() != 3 && sides.size() != 4) {
    throw InvalidShape(std::to_string(sides.size()) + " sides: three or four are needed");
  }
  Approximation<std::vector<NurbsCurve>> loop = border_loop(sides, tolerance);
  std::vector<glm::dvec4> all;
  for (NurbsCurve& side : loop.value) {
    side = over_unit(standard_form(side));
    all.insert(all.end(), side.points().begin(), side.points().end());
  }
  if (loop.value.size() == 3) loop.value.push_back(standing(glm::dvec3(loop.value[2].points().back())));
  const NearSpace space(all);
  std::vector<NurbsCurve> near;
  for (const NurbsCurve& side : loop.value) near.push_back(side.with_points(space.enter(side.points())));
  const NurbsCurve high = reversed(near[2]);
  const NurbsCurve left = reversed(near[3]);
  const NurbsPatch sum = boolean_sum(ruled(near[0], high), swapped(ruled(left, near[1])), bilinear(near[0], high));
  const NurbsPatch patch = sum.with_points(space.leave(sum.points()));
  return {with_sides(patch, loop.value[0], reversed(loop.value[2]), reversed(loop.value[3]), loop.value[1]), loop.error};
}

}  // namespace splinecore
