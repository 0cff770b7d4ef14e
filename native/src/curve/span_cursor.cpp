#include "span_cursor.hpp"

#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

SpanCursor::SpanCursor(const NurbsCurve& curve, std::size_t batch)
    : curve_(curve), order_(curve.degree() + 1), keeps_all_(batch >= curve.knot_vector().spans().size()) {
  for (int i = 0; i <= curve.degree(); ++i) binomials_.push_back(binomial(curve.degree(), i));
  const std::size_t kept = keeps_all_ ? curve.knot_vector().spans().size() : 1;
  is_known_.assign(kept, 0);
  memory_.resize(kept * order_);
}

void SpanCursor::compute(int span) {
  breathe(4 * order_ * order_);
  const KnotVector& knots = curve_.knot_vector();
  const auto matrix = knots.bezier_matrix(span);
  const glm::dvec4* first = curve_.homogeneous_points().data() + knots.spans()[span] - knots.degree();
  glm::dvec4* points = memory_.data() + (keeps_all_ ? span * order_ : 0);
  for (std::size_t j = 0; j < order_; ++j) points[j] = weighted_sum(matrix.subspan(j * order_, order_), first);
}

void SpanCursor::enter(int span) {
  const int place = keeps_all_ ? span : 0;
  if (!keeps_all_ || !is_known_[place]) compute(span);
  is_known_[place] = 1;
  span_ = span;
  range_ = curve_.knot_vector().span_interval(span);
  points_ = memory_.data() + place * order_;
}

glm::dvec4 SpanCursor::at(double u, Side side) {
  if (span_ < 0 || !(u > range_.start && u < range_.end)) {
    const int span = curve_.knot_vector().span_of(u, side);
    if (span != span_) enter(span);
  }
  const double length = range_.length();
  const double t = (u - range_.start) / length;
  const double s = (range_.end - u) / length;
  // Horner's scheme in Bernstein form (Volk and Schumaker 1990): a sum of products without a
  // difference, as stable as de Casteljau's algorithm.
  glm::dvec4 sum = points_[0];
  double power = 1.0;
  for (std::size_t i = 1; i < order_; ++i) {
    power *= t;
    sum = s * sum + (power * binomials_[i]) * points_[i];
  }
  return sum;
}

}  // namespace splinecore
