#include "splinecore/measure/features.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/one_sign.hpp"
#include "finite_weights.hpp"
#include "numerators.hpp"
#include "signs.hpp"
#include "unit_direction.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/continuity.hpp"

namespace splinecore {

namespace {

/// Where the weight of a piece is below zero the signs of its runs are turned, and they are cut where it is zero.
std::vector<Run> runs_by_weight(const std::vector<Run>& runs, const std::vector<glm::dvec4>& piece) {
  Numerator weight;
  for (const glm::dvec4& p : piece) {
    weight.coefficients.push_back(p.w);
    weight.noise = std::max(weight.noise, 0x1p-50 * static_cast<double>(piece.size()) * std::abs(p.w));
  }
  std::vector<Run> found;
  for (const Run& run : runs) {
    for (const Run& part : Signs(weight).runs) {
      const Interval both{std::max(run.part.start, part.part.start), std::min(run.part.end, part.part.end)};
      if (!(both.start < both.end)) continue;
      found.push_back({both, run.sign * part.sign, both.start == part.part.start && both.start > 0.0});
    }
  }
  return found;
}

/// Where signs change from run to run of all spans.
class Bends {
 public:
  explicit Bends(const NurbsCurve& curve) : curve_(curve) {}

  void add(const Interval& span, const std::vector<Run>& runs) {
    for (const Run& run : runs) {
      const double start = at(span, run.part.start);
      if (last_ != 0.0 && run.sign != last_ && !run.comes_from_infinity) turn(end_, start);
      if (last_ == 0.0) {
        first_ = run.sign;
        start_ = start;
      }
      last_ = run.sign;
      end_ = at(span, run.part.end);
    }
  }

  std::vector<double> found() && {
    const Interval domain = curve_.domain();
    if (curve_.periodic() && first_ != last_ && is_smooth(domain.start)) {
      const double rest = domain.end - end_;
      const double middle = 0.5 * ((start_ - domain.start) - rest);
      found_.push_back(middle < 0.0 ? domain.end + middle : domain.start + middle);
      std::ranges::sort(found_);
    }
    return std::move(found_);
  }

 private:
  void turn(double end, double start) {
    const double u = end + 0.5 * (start - end);
    if (end < start || is_smooth(u)) found_.push_back(u);
  }

  bool is_smooth(double u) const {
    const KnotVector& knots = curve_.knot_vector();
    return multiplicity(knots, u) < knots.degree() || continuity_at(curve_, u).g >= 1;
  }

  const NurbsCurve& curve_;
  double first_ = 0.0;
  double last_ = 0.0;
  double start_ = 0.0;  ///< of the first run
  double end_ = 0.0;    ///< of the last one
  std::vector<double> found_;
};

}  // namespace

glm::dvec3 plane_normal(const NurbsCurve& curve) {
  constexpr double kFlat = 1e-9;
  const NurbsCurve near = placed(curve, placement_of(curve.points()));
  const auto points = near.points();
  const glm::dvec4 base = *std::ranges::find_if(points, [](const glm::dvec4& p) { return p.w != 0.0; });
  const double size = extent(points);
  std::vector<glm::dvec3> legs;
  for (const glm::dvec4& p : points) {
    const glm::dvec3 leg = p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) - glm::dvec3(base);
    const double length = glm::length(leg);
    legs.push_back(p.w == 0.0 && length > 0.0 ? leg * ((size > 0.0 ? size : 1.0) / length) : leg);
  }
  const auto length_of = [](const glm::dvec3& leg) { return glm::length(leg); };
  const glm::dvec3 along = *std::ranges::max_element(legs, {}, length_of);
  const auto cross_length = [&](const glm::dvec3& leg) { return glm::length(glm::cross(along, leg)); };
  glm::dvec3 normal = glm::cross(along, *std::ranges::max_element(legs, {}, cross_length));
  const double most = glm::length(along);
  if (glm::length(normal) <= kFlat * most * most) {
    const glm::dvec3 direction = most > 0.0 ? along / most : glm::dvec3(0.0);
    int least = 2;
    for (const int axis : {1, 0}) {
      if (std::abs(direction[axis]) < std::abs(direction[least])) least = axis;
    }
    normal = glm::dvec3(0.0);
    normal[least] = 1.0;
    normal -= glm::dot(normal, direction) * direction;
  }
  normal = glm::normalize(normal);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double off = std::abs(glm::dot(legs[i], normal));
    if (off <= kFlat * most) continue;
    throw InvalidShape("the curve lies in no plane: points" + index_text(i) + " is off that of others by " +
                       text_of(off / most) + " of its size");
  }
  int axis = 2;
  while (axis > 0 && std::abs(normal[axis]) <= kFlat) --axis;
  return normal[axis] < 0.0 ? -normal : normal;
}

std::vector<double> inflections(const NurbsCurve& curve, const glm::dvec3& direction) {
  const glm::dvec3 view = unit_direction(direction, "direction");
  Bends bends(curve);
  const View from(view);
  for_each_span(near_origin(curve).curve, curve, [&](const Interval& span, const std::vector<glm::dvec4>& piece) {
    const Signs signs(bend_of(from.seen(piece)));
    bends.add(span, has_one_sign(piece, &glm::dvec4::w) && piece.front().w > 0.0 ? signs.runs
                                                                              : runs_by_weight(signs.runs, piece));
  });
  return std::move(bends).found();
}

std::vector<double> extrema(const NurbsCurve& curve, const glm::dvec3& direction) {
  const glm::dvec3 way = unit_direction(direction, "direction");
  require_finite_points(curve, curve.domain());
  const KnotVector& knots = curve.knot_vector();
  const Interval domain = curve.domain();
  std::vector<double> found;
  if (!curve.periodic()) found = {domain.start, domain.end};
  double first = 0.0;
  double last = 0.0;
  for_each_span(near_origin(curve).curve, curve, [&](const Interval& span, const std::vector<glm::dvec4>& piece) {
    std::vector<glm::dvec2> line;
    for (const glm::dvec4& p : piece) line.emplace_back(glm::dot(glm::dvec3(p), way), p.w);
    const Signs signs(slope_of(line));
    if (multiplicity(knots, span.start) > knots.degree()) found.push_back(span.start);
    for (const Interval& zero : signs.zeros) found.insert(found.end(), {at(span, zero.start), at(span, zero.end)});
    for (const Run& run : signs.runs) {
      // Inside a span signs change at zeros.
      if (last != 0.0 && run.sign != last && run.part.start == 0.0) found.push_back(span.start);
      if (first == 0.0) first = run.sign;
      last = run.sign;
    }
  });
  if (curve.periodic() && first != last) found.push_back(domain.start);
  if (curve.periodic()) std::ranges::replace(found, domain.end, domain.start);
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

}  // namespace splinecore
