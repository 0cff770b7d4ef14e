#include "splinecore/curve/moebius.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/basis/selection.hpp"

namespace splinecore {

namespace {

/// u = t (b - a) + a is mapped to where t is reached under the new parameter.
class Map {
 public:
  Map(Interval domain, double rho) : domain_(domain), rho_(rho) {}

  bool is_beyond_pole(double u) const { return !(denominator(u) > 0.0); }

  double at(double u) const {
    if (u == domain_.start || u == domain_.end) return u;
    // From the nearer end, so that rounding is relative to the shorter way.
    const double late = rho_ * (domain_.end - u);
    const double early = u - domain_.start;
    return late < early ? domain_.end - late / denominator(u) : domain_.start + early / denominator(u);
  }

  /// What one factor of a polar form at u is multiplied by.
  double factor(double u) const { return rho_ / denominator(u); }

 private:
  double denominator(double u) const {
    if (u == domain_.start) return rho_;
    if (u == domain_.end) return 1.0;
    return (rho_ * (domain_.end - u) + (u - domain_.start)) / (domain_.end - domain_.start);
  }

  Interval domain_;
  double rho_;
};

void require_positive(double rho) {
  if (rho > 0.0 && std::isfinite(rho)) return;
  throw InvalidShape("rho = " + text_of(rho) + " is not positive: the map would not keep the curve");
}

/// The given point whose homogeneous point is multiplied by a factor.
glm::dvec4 multiplied(const glm::dvec4& given, double factor, std::size_t index) {
  const bool is_direction = given.w == 0.0;
  const glm::dvec4 point = is_direction ? factor * given : glm::dvec4(glm::dvec3(given), factor * given.w);
  const bool vanished = !is_direction && !std::isnormal(point.w);
  if (std::isfinite(factor) && !vanished) return point;
  throw InvalidShape("weights" + index_text(index) + " = " + text_of(given.w) + " times " + text_of(factor) +
                     " leaves the range of numbers");
}

NurbsCurve part(const NurbsCurve& curve, const Selection& selection) {
  std::vector<glm::dvec4> points;
  for (const int i : selection.indices) points.push_back(curve.points()[i]);
  return NurbsCurve::make(selection.knots, std::move(points));
}

NurbsCurve with_full_knot(const NurbsCurve& curve, double u) {
  const std::vector<double> copies(std::max(0, missing_for_cut(curve.knot_vector(), u)), u);
  return copies.empty() ? curve : refine(curve, copies);
}

/// The curve over its domain alone, with no knot outside it.
NurbsCurve clamped(const NurbsCurve& curve) {
  const Interval domain = curve.domain();
  const NurbsCurve started = with_full_knot(curve, domain.start);
  const NurbsCurve after = part(started, part_after(started.knot_vector(), domain.start));
  const NurbsCurve ended = with_full_knot(after, domain.end);
  return part(ended, part_before(ended.knot_vector(), domain.end));
}

/// A plain curve that the map can take as it is.
NurbsCurve prepared(const NurbsCurve& curve, const Map& map) {
  if (curve.periodic()) return opened(curve, curve.domain().start);
  const auto knots = curve.knot_vector().knots();
  const bool reaches_pole = map.is_beyond_pole(knots.front()) || map.is_beyond_pole(knots.back());
  return reaches_pole ? clamped(curve) : curve;
}

NurbsCurve mapped(const NurbsCurve& curve, const Map& map) {
  const auto old = curve.knot_vector().knots();
  std::vector<double> knots;
  for (const double u : old) {
    const double moved = map.at(u);
    // Rounding may bring two neighbours out of order by an ulp.
    knots.push_back(knots.empty() ? moved : std::max(moved, knots.back()));
  }
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < curve.points().size(); ++i) {
    double factor = 1.0;
    for (int j = 1; j <= curve.degree(); ++j) factor *= map.factor(old[i + j]);
    points.push_back(multiplied(curve.points()[i], factor, i));
  }
  return NurbsCurve::make(curve.degree(), std::move(knots), std::move(points));
}

double standard_rho(const NurbsCurve& curve) {
  const double first = curve.points().front().w;
  const double last = curve.points().back().w;
  if ((first > 0.0 && last > 0.0) || (first < 0.0 && last < 0.0)) return std::pow(first / last, 1.0 / curve.degree());
  throw InvalidShape("weights[0] = " + text_of(first) + " and weights[" + std::to_string(curve.points().size() - 1) +
                     "] = " + text_of(last) + " have not one sign: there is no standard form");
}

/// All weights divided by the first; the last becomes 1 to every digit.
std::vector<glm::dvec4> normalised(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> scaled;
  for (std::size_t i = 0; i < points.size(); ++i) scaled.push_back(multiplied(points[i], 1.0 / points.front().w, i));
  scaled.front().w = scaled.back().w = 1.0;
  return scaled;
}

}  // namespace

NurbsCurve moebius(const NurbsCurve& curve, double rho) {
  require_positive(rho);
  const Map map(curve.domain(), rho);
  return mapped(prepared(curve, map), map);
}

BezierCurve moebius(const BezierCurve& curve, double rho) {
  const NurbsCurve form = moebius(curve.nurbs(), rho);
  return BezierCurve::make({form.points().begin(), form.points().end()});
}

NurbsCurve standard_form(const NurbsCurve& curve) {
  const KnotVector& knots = curve.knot_vector();
  const Interval domain = curve.domain();
  const bool is_clamped = !curve.periodic() && multiplicity(knots, domain.start) == curve.degree() + 1 &&
                          multiplicity(knots, domain.end) == curve.degree() + 1;
  if (!is_clamped) throw InvalidShape("the curve is not clamped at both ends: it has no end weights");
  const NurbsCurve moved = moebius(curve, standard_rho(curve));
  return moved.with_points(normalised(moved.points()));
}

BezierCurve standard_form(const BezierCurve& curve) {
  const BezierCurve moved = moebius(curve, standard_rho(curve.nurbs()));
  return moved.with_points(normalised(moved.points()));
}

}  // namespace splinecore
