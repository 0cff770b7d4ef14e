#include <array>
#include <string>

#include "base/require.hpp"
#include "influence.hpp"
#include "least_change.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/build/drag.hpp"

namespace splinecore {

namespace {

/// Whether the curve begins and ends in its outer points.
bool touches_ends(const KnotVector& knots) {
  const auto u = knots.knots();
  const auto degree = static_cast<std::size_t>(knots.degree());
  return !knots.periodic() && u.front() == u[degree] && u.back() == u[u.size() - 1 - degree];
}

bool lie_together(const glm::dvec4& a, const glm::dvec4& b) {
  return a.w != 0.0 && b.w != 0.0 && glm::dvec3(a) == glm::dvec3(b);
}

Motion motion_of(const Movable& movable, double u, const Drag& drag, const Following& following) {
  require_finite(std::span(&drag.by, 1), "by");
  if (drag.tangent_by) require_finite(std::span(&*drag.tangent_by, 1), "tangent_by");
  if (drag.second_by) require_finite(std::span(&*drag.second_by, 1), "second_by");
  if (drag.second_by && !drag.tangent_by) throw InvalidShape("second_by is given without tangent_by: zero keeps the tangent");
  constexpr std::array<const char*, 2> kNames{"the tangent", "the second derivative"};
  const std::size_t count = drag.second_by ? 2 : drag.tangent_by ? 1 : 0;
  return least_change(movable, std::span(kNames).first(count), following, "u = " + text_of(u));
}

glm::dvec3 step_of(const Motion& motion, std::size_t i, const Drag& drag) {
  glm::dvec3 step = motion[0][i] * drag.by;
  if (drag.tangent_by) step += motion[1][i] * *drag.tangent_by;
  if (drag.second_by) step += motion[2][i] * *drag.second_by;
  return step;
}

void move(glm::dvec3& vector, const glm::dvec3& step) {
  if (step != glm::dvec3(0.0)) vector += step;  // -0 stays -0
}

std::vector<glm::dvec4> dragged_points(const NurbsCurve& curve, double u, const Drag& drag, const Following& following) {
  Influence influence = Influence::at(curve.knot_vector(), u);
  if (!make_rational(influence, curve.points())) throw PointAtInfinity(u);
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  Movable movable(points.size());
  movable.in_point = std::move(influence.value);
  movable.in_first = std::move(influence.slope);
  movable.in_second = std::move(influence.bend);
  for (std::size_t i = 0; i < points.size(); ++i) movable.is_fixed[i] = points[i].w == 0.0;
  if (touches_ends(curve.knot_vector()) && lie_together(points.front(), points.back())) {
    movable.tie(0, static_cast<int>(points.size()) - 1);
  }
  const Motion motion = motion_of(movable, u, drag, following);
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::dvec3 place(points[i]);
    move(place, step_of(motion, i, drag));
    points[i] = glm::dvec4(place, points[i].w);
  }
  return points;
}

/// Of points, incoming and outgoing tangents one after the other.
Movable movable_of(const HermiteCurve& curve, double u) {
  const auto count = curve.points().size();
  const HermiteInfluence at = HermiteInfluence::at(curve.parameters(), u);
  Movable movable(3 * count);
  const auto put = [&](std::size_t first, const Influence& influence, const std::vector<double>& measure) {
    std::copy(influence.value.begin(), influence.value.end(), movable.in_point.begin() + first);
    std::copy(influence.slope.begin(), influence.slope.end(), movable.in_first.begin() + first);
    std::copy(influence.bend.begin(), influence.bend.end(), movable.in_second.begin() + first);
    std::copy(measure.begin(), measure.end(), movable.measure.begin() + first);
  };
  put(0, at.points, std::vector<double>(count, 1.0));
  put(count, at.incoming, at.before);
  put(2 * count, at.outgoing, at.after);
  const auto n = static_cast<int>(count);
  const auto tangents = curve.tangents();
  for (int i = 0; i < n; ++i) {
    if (tangents[i].incoming == tangents[i].outgoing) movable.tie(n + i, 2 * n + i);
  }
  if (curve.points().front() == curve.points().back()) {
    movable.tie(0, n - 1);
    if (tangents.front().incoming == tangents.back().incoming) movable.tie(n, 2 * n - 1);
    if (tangents.front().outgoing == tangents.back().outgoing) movable.tie(2 * n, 3 * n - 1);
  }
  return movable;
}

}  // namespace

NurbsCurve dragged(const NurbsCurve& curve, double u, const Drag& drag, const Following& following) {
  return curve.with_points(dragged_points(curve, u, drag, following));
}

BezierCurve dragged(const BezierCurve& curve, double u, const Drag& drag, const Following& following) {
  return curve.with_points(dragged_points(curve.nurbs(), u, drag, following));
}

HermiteCurve dragged(const HermiteCurve& curve, double u, const Drag& drag, const Following& following) {
  const Motion motion = motion_of(movable_of(curve, u), u, drag, following);
  std::vector<glm::dvec3> points(curve.points().begin(), curve.points().end());
  std::vector<Tangents> tangents(curve.tangents().begin(), curve.tangents().end());
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    move(points[i], step_of(motion, i, drag));
    move(tangents[i].incoming, step_of(motion, count + i, drag));
    move(tangents[i].outgoing, step_of(motion, 2 * count + i, drag));
  }
  return HermiteCurve::make(std::move(points), std::move(tangents),
                            {curve.parameters().begin(), curve.parameters().end()});
}

}  // namespace splinecore
