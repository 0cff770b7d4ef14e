#include "sharp_tips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "bezier_runs.hpp"
#include "curve_parts.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/meet/intersections.hpp"

namespace splinecore {

namespace {

/// How far a place is inside of a tip; below zero outside.
double depth_in(const SharpTip& tip, const glm::dvec3& place) {
  double depth = glm::distance(tip.corner, tip.tip);
  for (const glm::dvec3& moved : {tip.start, tip.end}) {
    depth = std::min({depth, glm::dot(moved - place, glm::normalize(moved - tip.corner)),
                      glm::dot(place - tip.corner, glm::normalize(tip.tip - moved))});
  }
  return depth;
}

glm::dvec3 place_at(const NurbsCurve& curve, double parameter) {
  glm::dvec3 place;
  evaluate(curve, std::span(&parameter, 1), std::span(&place.x, 3));
  return place;
}

NurbsCurve border_of(const SharpTip& tip) {
  BezierPieces sides;
  const std::array around{tip.corner, tip.start, tip.tip, tip.end, tip.corner};
  for (std::size_t i = 0; i + 1 < around.size(); ++i) sides.push_back(bezier_line(around[i], around[i + 1]));
  return curve_of(sides);
}

/// Where the curve meets the border of a tip, by the parameters of both.
struct TipCrossing {
  double a;
  double b;
  bool is_corner;
};

std::vector<TipCrossing> crossings_of(const NurbsCurve& curve, const NurbsCurve& border, const SharpTip& tip, double slack) {
  const CurveIntersections found = intersections(curve, border);
  std::vector<TipCrossing> crossings;
  const auto add = [&](double a, double b) {
    const glm::dvec3 place = place_at(border, b);
    crossings.push_back({a, b, glm::distance(place, tip.corner) <= slack});
  };
  for (const CurveIntersection& place : found.places) add(place.a, place.b);
  for (const CurveOverlap& overlap : found.overlaps) {
    add(overlap.a.start, overlap.is_reversed ? overlap.b.end : overlap.b.start);
    add(overlap.a.end, overlap.is_reversed ? overlap.b.start : overlap.b.end);
  }
  std::ranges::stable_sort(crossings, {}, &TipCrossing::a);
  return crossings;
}

void append(std::vector<glm::dvec3>& polygon, std::vector<glm::dvec3> more, bool is_reversed) {
  if (is_reversed) std::ranges::reverse(more);
  polygon.insert(polygon.end(), more.begin(), more.end());
}

/// The part of a curve from one parameter to another, by way of its end if that is less.
std::vector<glm::dvec3> samples_between(const NurbsCurve& curve, double from, double to) {
  if (from < to) return samples_of(part_of(curve, {from, to}));
  std::vector<glm::dvec3> samples;
  if (from < curve.domain().end) samples = samples_of(part_of(curve, {from, curve.domain().end}));
  if (to > curve.domain().start) append(samples, samples_of(part_of(curve, {curve.domain().start, to})), false);
  return samples;
}

/// Parts of a tip behind a curve that goes through it, as seen from its corner.
std::vector<std::vector<glm::dvec3>> parts_cut_off(const NurbsCurve& curve, const SharpTip& tip, double slack) {
  const NurbsCurve border = border_of(tip);
  const std::vector<TipCrossing> crossings = crossings_of(curve, border, tip, slack);
  const bool is_round = glm::distance(place_at(curve, curve.domain().start), place_at(curve, curve.domain().end)) <= slack;
  std::vector<std::vector<glm::dvec3>> parts;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const bool is_last = i + 1 == crossings.size();
    if (is_last && (!is_round || crossings.size() < 2)) break;
    const TipCrossing& from = crossings[i];
    const TipCrossing& to = crossings[is_last ? 0 : i + 1];
    std::vector<glm::dvec3> part = samples_between(curve, from.a, to.a);
    if (part.empty() || !(depth_in(tip, part[part.size() / 2]) > slack)) continue;
    // The border begins and ends at the corner: the curve arrives there beside its start and leaves beside its end.
    const double start = from.is_corner ? border.domain().end : from.b;
    const double end = to.is_corner ? border.domain().start : to.b;
    const Interval between{std::min(start, end), std::max(start, end)};
    if (!(between.length() > 0.0)) continue;
    append(part, samples_of(part_of(border, between)), start < end);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Whether a polygon in the plane of a tip runs around a place.
bool is_around(std::span<const glm::dvec3> polygon, const SharpTip& tip, const glm::dvec3& place) {
  const glm::dvec3 x = glm::normalize(tip.tip - tip.corner);
  const glm::dvec3 across = tip.start - tip.corner;
  const glm::dvec3 y = across - glm::dot(across, x) * x;
  bool is_odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p = polygon[i] - place;
    const glm::dvec3 q = polygon[(i + 1) % polygon.size()] - place;
    const double low = glm::dot(p, y);
    const double high = glm::dot(q, y);
    if ((low > 0.0) == (high > 0.0)) continue;
    if (glm::dot(p, x) - low / (high - low) * (glm::dot(q, x) - glm::dot(p, x)) > 0.0) is_odd = !is_odd;
  }
  return is_odd;
}

}  // namespace

SharpTips::SharpTips(const NurbsCurve& curve, std::vector<SharpTip> tips, double slack) : tips_(std::move(tips)), slack_(slack) {
  for (const SharpTip& tip : tips_) {
    breathe(1);
    cut_off_.push_back(parts_cut_off(curve, tip, slack));
  }
}

bool SharpTips::cover(const glm::dvec3& place) const { return any(place, slack_); }

bool SharpTips::hold(const glm::dvec3& place) const { return any(place, -slack_); }

bool SharpTips::any(const glm::dvec3& place, double inside) const {
  constexpr double kInwards = 0x1p-20;  // places on the border of a tip are on that of what is cut off, too
  for (std::size_t i = 0; i < tips_.size(); ++i) {
    if (!(depth_in(tips_[i], place) > inside)) continue;
    const glm::dvec3 within = glm::mix(place, 0.5 * (tips_[i].corner + tips_[i].tip), kInwards);
    if (std::ranges::none_of(cut_off_[i], [&](const auto& part) { return is_around(part, tips_[i], within); })) return true;
  }
  return false;
}

}  // namespace splinecore
