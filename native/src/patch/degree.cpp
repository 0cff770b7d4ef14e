#include "splinecore/patch/degree.hpp"

#include <string>

#include "base/require.hpp"
#include "basis/elevation.hpp"
#include "curve/of_lower_degree.hpp"
#include "lines.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/curve/bezier_degree.hpp"
#include "splinecore/curve/degree.hpp"
#include "tolerance.hpp"

namespace splinecore {

namespace {

void require_lower(int times, int degree) {
  if (times >= 1 && times < degree) return;
  throw InvalidShape("times = " + std::to_string(times) + " is outside [1, " + std::to_string(degree - 1) +
                     "]: a patch needs degree 1 or more");
}

constexpr const char* kRefusal = "the degree cannot be lowered";

}  // namespace

NurbsPatch elevated(const NurbsPatch& patch, Axis axis, int times) {
  const int most = kMaxDegree - patch.knot_vector(axis).degree();
  if (times < 0 || times > most) {
    throw InvalidShape("times = " + std::to_string(times) + " is outside [0, " + std::to_string(most) + "]");
  }
  NurbsPatch raised = patch;
  for (int i = 0; i < times; ++i) raised = applied(elevation(raised.knot_vector(axis)), raised, axis);
  return raised;
}

Approximation<NurbsPatch> reduced(const NurbsPatch& patch, Axis axis, int times, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  require_lower(times, patch.knot_vector(axis).degree());
  NurbsPatch lower = along(patch, axis, [&](const NurbsCurve& line) { return of_lower_degree(line, times); });
  return within(tolerance, patch, std::move(lower), kRefusal);
}

BezierPatch elevated(const BezierPatch& patch, Axis axis, int times) {
  return as_bezier(along(patch.nurbs(), axis, [&](const NurbsCurve& line) {
    return elevated(as_bezier(line), times).nurbs();
  }));
}

Approximation<BezierPatch> reduced(const BezierPatch& patch, Axis axis, int times, std::optional<double> tolerance) {
  if (tolerance) require_tolerance(*tolerance);
  require_lower(times, patch.degree(axis));
  NurbsPatch lower = along(patch.nurbs(), axis, [&](const NurbsCurve& line) {
    return reduced(as_bezier(line), times).value.nurbs();
  });
  const Approximation<NurbsPatch> found = within(tolerance, patch.nurbs(), std::move(lower), kRefusal);
  return {as_bezier(found.value), found.error};
}

}  // namespace splinecore
