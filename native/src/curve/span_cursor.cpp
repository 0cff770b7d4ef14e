#include "span_cursor.hpp"

#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

SpanCursor::SpanCursor(const NurbsCurve& curve) : curve_(curve), points_(curve.degree() + 1) {
  for (int i = 0; i <= curve.degree(); ++i) binomials_.push_back(binomial(curve.degree(), i));
  enter(0);
}

void SpanCursor::enter(int span) {
  const KnotVector& knots = curve_.knot_vector();
  const std::size_t order = points_.size();
  const auto matrix = knots.bezier_matrix(span);
  const glm::dvec4* first = curve_.homogeneous_points().data() + knots.spans()[span] - knots.degree();
  for (std::size_t j = 0; j < order; ++j) points_[j] = weighted_sum(matrix.subspan(j * order, order), first);
  range_ = knots.span_interval(span);
}

glm::dvec4 SpanCursor::at(double u, Side side) {
  if (!(u > range_.start && u < range_.end)) {
    const int span = curve_.knot_vector().span_of(u, side);
    if (curve_.knot_vector().span_interval(span) != range_) enter(span);
  }
  const double length = range_.length();
  const double t = (u - range_.start) / length;
  const double s = (range_.end - u) / length;
  // Horner's scheme in Bernstein form (Volk and Schumaker 1990): a sum of products without a
  // difference, as stable as de Casteljau's algorithm.
  glm::dvec4 sum = points_[0];
  double power = 1.0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    power *= t;
    sum = s * sum + (power * binomials_[i]) * points_[i];
  }
  return sum;
}

}  // namespace splinecore
