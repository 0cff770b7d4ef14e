#include "curve_ends.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/measure/curve_frame.hpp"

namespace splinecore {

namespace {

DirectedEnd place_of(const NurbsCurve& curve, double u, Side side) {
  std::array<glm::dvec3, 2> d;
  derivatives(curve, std::span(&u, 1), 1, std::span(&d[0].x, 6), {.side = side});
  MovingFrame frame;
  frenet_frames(curve, std::span(&u, 1), std::span(&frame, 1), side);
  if (std::isnan(frame.tangent.x)) throw InvalidShape("a curve has a zero derivative at its end: it has no direction there");
  return {d[0], frame.tangent, glm::length(d[1])};
}

}  // namespace

DirectedEnd start_of(const NurbsCurve& curve) { return place_of(curve, curve.domain().start, Side::right); }
DirectedEnd end_of(const NurbsCurve& curve) { return place_of(curve, curve.domain().end, Side::left); }

glm::dvec3 point_at(const NurbsCurve& curve, double u) {
  glm::dvec3 point;
  evaluate(curve, std::span(&u, 1), std::span(&point.x, 3));
  return point;
}

NurbsCurve line_between(const glm::dvec3& a, const glm::dvec3& b) {
  return NurbsCurve::make(1, {0.0, 0.0, 1.0, 1.0}, {glm::dvec4(a, 1.0), glm::dvec4(b, 1.0)});
}

std::optional<double> parameter_along(const NurbsCurve& curve, double length) {
  const Interval domain = curve.domain();
  const double whole = lengths_at_parameters(curve, std::span(&domain.end, 1)).front();
  const double room = kNothing * whole;
  if (!(length >= -room && length <= whole + room)) return {};
  if (length <= room) return domain.start;
  if (length >= whole - room) return domain.end;
  return parameters_at_lengths(curve, std::span(&length, 1)).front();
}

NurbsCurve follow(const NurbsCurve& curve, const NurbsCurve& more) {
  const double speed = end_of(curve).speed;
  const double own = start_of(more).speed * more.domain().length();
  const double start = curve.domain().end;
  const double stretch = speed > 0.0 && own > 0.0 ? own / speed : curve.domain().length();
  return joined(curve, with_domain(more, {start, start + stretch}), Smoothness::c0).value;
}

NurbsCurve with_one_end(const NurbsCurve& curve) {
  std::vector<glm::dvec4> points(curve.points().begin(), curve.points().end());
  const glm::dvec3 middle = 0.5 * glm::dvec3(points.front()) + 0.5 * glm::dvec3(points.back());
  points.front() = glm::dvec4(middle, points.front().w);
  points.back() = glm::dvec4(middle, points.back().w);
  return curve.with_points(std::move(points));
}

NurbsCurve chained(std::span<const NurbsCurve> curves) {
  if (curves.size() == 1) return curves.front();
  // By halves: to put one behind the other would copy all before it each time.
  const std::size_t middle = curves.size() / 2;
  return follow(chained(curves.first(middle)), chained(curves.subspan(middle)));
}

}  // namespace splinecore
