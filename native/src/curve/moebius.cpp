#include "splinecore/curve/moebius.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "basis/moebius.hpp"
#include "basis/selection.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

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
NurbsCurve prepared(const NurbsCurve& curve, double rho) {
  const bool reaches_pole = has_moebius_pole(curve.knot_vector(), rho);
  if (curve.periodic()) return opened(curve, curve.domain().start);
  return reaches_pole ? clamped(curve) : curve;
}

double standard_rho(const NurbsCurve& curve) {
  const double first = curve.points().front().w;
  const double last = curve.points().back().w;
  if ((first > 0.0 && last > 0.0) || (first < 0.0 && last < 0.0)) return std::pow(first / last, 1.0 / curve.degree());
  throw InvalidShape("weights[0] = " + text_of(first) + " and weights[" + std::to_string(curve.points().size() - 1) +
                     "] = " + text_of(last) + " have not one sign: there is no standard form");
}

/// All weights divided by the first; the last becomes 1 to every digit.
std::vector<glm::dvec4> normalized(std::span<const glm::dvec4> points) {
  std::vector<glm::dvec4> scaled;
  for (std::size_t i = 0; i < points.size(); ++i) scaled.push_back(multiplied(points[i], 1.0 / points.front().w, i));
  scaled.front().w = scaled.back().w = 1.0;
  return scaled;
}

}  // namespace

NurbsCurve moebius(const NurbsCurve& curve, double rho) {
  const NurbsCurve plain = prepared(curve, rho);
  MoebiusKnots mapped = moebius(plain.knot_vector(), rho);
  std::vector<glm::dvec4> points;
  for (std::size_t i = 0; i < plain.points().size(); ++i) {
    points.push_back(multiplied(plain.points()[i], mapped.factors[i], i));
  }
  return NurbsCurve::make(plain.degree(), std::move(mapped.knots), std::move(points));
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
  return moved.with_points(normalized(moved.points()));
}

BezierCurve standard_form(const BezierCurve& curve) {
  const BezierCurve moved = moebius(curve, standard_rho(curve.nurbs()));
  return moved.with_points(normalized(moved.points()));
}

}  // namespace splinecore
