#include "splinecore/curve/nurbs_curve.hpp"

#include <string>

#include "base/given_points.hpp"
#include "basis/bernstein_net.hpp"
#include "basis/refinement.hpp"
#include "basis/selection.hpp"
#include "curve_tables.hpp"
#include "made_of.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

NurbsCurve::NurbsCurve(KnotVector knots, std::vector<glm::dvec4> points)
    : knots_(std::move(knots)), points_(std::move(points)), rational_(is_rational(points_)),
      weight_exponent_(rational_ ? splinecore::weight_exponent(points_) : 0),
      homogeneous_(rational_ || knots_.periodic() ? homogeneous(points_, weight_exponent_) : std::vector<glm::dvec4>{}),
      tables_(std::make_shared<CurveTables>(knots_.spans().size(), knots_.degree())) {
  for (int i = 0; i < knots_.unrolled_count() - knots_.count(); ++i) {
    homogeneous_.push_back(homogeneous_[i]);
  }
}

NurbsCurve NurbsCurve::make(KnotVector knots, std::vector<glm::dvec4> points) {
  if (knots.degree() < 1) throw InvalidShape("degree = 0: a curve needs degree 1 or more");
  if (points.size() != static_cast<std::size_t>(knots.count())) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, but " +
                       std::to_string(knots.knots().size()) + " knots of degree " +
                       std::to_string(knots.degree()) + " belong to " +
                       std::to_string(knots.count()));
  }
  static_cast<void>(knots.domain());
  require_points(points);
  return {std::move(knots), std::move(points)};
}

NurbsCurve NurbsCurve::make(int degree, std::vector<double> knots, std::vector<glm::dvec4> points,
                            bool periodic) {
  if (degree < 1) throw InvalidShape("degree = " + std::to_string(degree) + ": a curve needs degree 1 or more");
  return make(KnotVector::make(degree, std::move(knots), periodic), std::move(points));
}

NurbsCurve NurbsCurve::from_homogeneous(KnotVector knots, std::span<const glm::dvec4> points) {
  return make(std::move(knots), as_given(points));
}

NurbsCurve applied(const PointMatrix& matrix, const NurbsCurve& curve) {
  std::vector<glm::dvec4> points(matrix.knots().count());
  matrix.apply(curve.homogeneous_points().data(), 1, points.data(), 1);
  GivenPoints given = as_given_from(curve, points);
  matrix.keep_untouched(given.old.data(), 1, given.made.data(), 1);
  return NurbsCurve::make(matrix.knots(), std::move(given.made));
}

NurbsCurve made_of(const NurbsCurve& curve, KnotVector knots, std::vector<glm::dvec4> points,
                   std::span<const int> copied) {
  if (!curve.rational()) {
    for (glm::dvec4& point : points) point.w = 1.0;
    return NurbsCurve::make(std::move(knots), std::move(points));
  }
  GivenPoints given = as_given_from(curve, points);
  for (std::size_t i = 0; i < copied.size(); ++i) {
    if (copied[i] >= 0) given.made[i] = given.old[copied[i]];
  }
  return NurbsCurve::make(std::move(knots), std::move(given.made));
}

NurbsCurve refine(const NurbsCurve& curve, std::span<const double> inserted) {
  if (curve.periodic()) return applied(refinement(curve.knot_vector(), inserted), curve);
  auto [knots, points, copied] =
      refined(curve.knot_vector(), curve.homogeneous_points(), inserted, curve.rational());
  return made_of(curve, std::move(knots), std::move(points), copied);
}

NurbsCurve insert_knot(const NurbsCurve& curve, double u, int times) {
  return refine(curve, knot_copies(curve.knot_vector(), u, times));
}

namespace {

/// With u of multiplicity degree + 1, so that the curve falls apart there.
NurbsCurve cut(const NurbsCurve& curve, double u) {
  const std::vector<double> copies(missing_for_cut(curve.knot_vector(), u), u);
  return copies.empty() ? curve : refine(curve, copies);
}

NurbsCurve selected(const NurbsCurve& curve, const Selection& selection) {
  std::vector<glm::dvec4> points;
  points.reserve(selection.indices.size());
  for (const int i : selection.indices) points.push_back(curve.points()[i]);
  return NurbsCurve::make(selection.knots, std::move(points));
}

}  // namespace

std::pair<NurbsCurve, NurbsCurve> split(const NurbsCurve& curve, double u) {
  require_inside(curve.knot_vector(), u);
  const NurbsCurve whole = cut(curve, u);
  return {selected(whole, part_before(whole.knot_vector(), u)),
          selected(whole, part_after(whole.knot_vector(), u))};
}

NurbsCurve opened(const NurbsCurve& curve, double u) {
  if (!curve.periodic()) throw InvalidShape("only a periodic curve can be opened");
  const double start = curve.knot_vector().admit(u, Side::right);
  const NurbsCurve whole = cut(curve, start);
  return selected(whole, opened_at(whole.knot_vector(), start));
}

NurbsCurve unrolled(const NurbsCurve& curve) {
  return curve.periodic() ? selected(curve, unrolled(curve.knot_vector())) : curve;
}

NurbsCurve reversed(const NurbsCurve& curve) { return selected(curve, reversed(curve.knot_vector())); }

void bezier_points(const NurbsCurve& curve, std::span<glm::dvec4> out) {
  const std::size_t order = curve.degree() + 1;
  for (std::size_t span = 0; span < curve.knot_vector().spans().size(); ++span) {
    write_bezier_piece(curve.knot_vector(), static_cast<int>(span), curve.homogeneous_points().data(),
                       out.data() + span * order);
  }
}

}  // namespace splinecore
