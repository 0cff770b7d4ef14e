#include "scale_along.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>

#include "base/rounding.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

constexpr int kCubic = 3;

void require_points(const NurbsCurve& curve) {
  for (const glm::dvec4& p : curve.points()) {
    if (!(p.w > 0.0 && std::isfinite(p.w))) throw InvalidShape("a weight of a scale is not above 0");
    if (!(p.x > 0.0 && std::isfinite(p.x))) throw InvalidShape("a scale of " + text_of(p.x) + ": above 0 is expected");
  }
}

bool is_inside(const Interval& domain, double at) { return at > domain.start && at < domain.end; }

}  // namespace

ScaleAlong::ScaleAlong(const NurbsCurve& curve, const Interval& domain, bool is_closed) : curve_(curve) {
  require_points(curve);
  const Interval own = curve.domain();
  if (own.start != domain.start || own.end != domain.end) {
    throw InvalidShape("a scale runs from " + text_of(own.start) + " to " + text_of(own.end) + ", the rail from " +
                       text_of(domain.start) + " to " + text_of(domain.end));
  }
  for (const double knot : curve.knot_vector().knots()) {
    if (is_inside(own, knot) && multiplicity(curve.knot_vector(), knot) > curve.knot_vector().degree()) {
      throw InvalidShape("a scale jumps at " + text_of(knot));
    }
  }
  if (!is_closed) return;
  if (!curve.periodic() && std::abs(at(own.start) - at(own.end)) > kRoundingOfPlace * largest()) {
    throw InvalidShape("the rail is closed: the scale at its end must be that at its start");
  }
  goes_round_ = is_smooth_round();
}

bool ScaleAlong::is_smooth_round() const {
  const KnotVector& knots = curve_.knot_vector();
  if (curve_.periodic()) return multiplicity(knots, curve_.domain().start) < knots.degree();
  std::array<glm::dvec3, 2> first;
  std::array<glm::dvec3, 2> last;
  const Interval own = curve_.domain();
  derivatives(curve_, std::span(&own.start, 1), 1, std::span(&first[0].x, 6), {.side = Side::right});
  derivatives(curve_, std::span(&own.end, 1), 1, std::span(&last[0].x, 6), {.side = Side::left});
  return std::abs(first[1].x - last[1].x) * own.length() <= kRoundingOfTouch * largest();
}

double ScaleAlong::at(double parameter) const {
  const Interval own = curve_.domain();
  const double inside = std::clamp(parameter > own.end ? parameter - own.length() : parameter, own.start, own.end);
  glm::dvec3 found;
  evaluate(curve_, std::span(&inside, 1), std::span(&found.x, 3));
  return found.x;
}

bool ScaleAlong::is_one() const {
  const auto points = curve_.points();
  return std::ranges::all_of(points, [&](const glm::dvec4& p) { return p.x == points.front().x; });
}

double ScaleAlong::largest() const {
  return std::ranges::max(curve_.points(), {}, [](const glm::dvec4& p) { return p.x; }).x;
}

/// And how often a cubic spline has its own there: three times at corners.
std::vector<RowJoint> ScaleAlong::inner_knots(const Interval& rail) const {
  const KnotVector& knots = curve_.knot_vector();
  const Interval own = curve_.domain();
  const auto copies = [&](double knot) { return std::clamp(kCubic - knots.degree() + multiplicity(knots, knot), 1, kCubic); };
  std::vector<RowJoint> found;
  for (const double knot : knots.knots()) {
    if (!is_inside(own, knot) || (!found.empty() && found.back().at == knot)) continue;
    found.push_back({knot, copies(knot)});
  }
  if (rail.start == own.start) return found;
  for (RowJoint& joint : found) {
    if (joint.at <= rail.start) joint.at += own.length();
  }
  found.push_back({own.end, goes_round_ ? 2 : kCubic});
  std::ranges::sort(found, {}, &RowJoint::at);
  std::erase_if(found, [&](const RowJoint& joint) { return !is_inside(rail, joint.at); });
  return found;
}

std::vector<RowJoint> ScaleAlong::joints(const Interval& rail) const {
  std::vector<RowJoint> found = inner_knots(rail);
  std::erase_if(found, [](const RowJoint& joint) { return joint.copies == kCubic; });
  return found;
}

std::vector<double> ScaleAlong::corners(const Interval& rail) const {
  std::vector<double> found;
  for (const RowJoint& joint : inner_knots(rail)) {
    if (joint.copies == kCubic) found.push_back(joint.at);
  }
  return found;
}

}  // namespace splinecore
