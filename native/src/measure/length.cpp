#include "splinecore/measure/length.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/placement.hpp"
#include "quadrature.hpp"
#include "regular_parts.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/rescale.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMostCells = 20'000;

double admitted(double u, const Interval& domain, const char* name) {
  constexpr double kSlack = 4.0 * std::numeric_limits<double>::epsilon();
  const double slack = kSlack * std::max(std::abs(domain.start), std::abs(domain.end));
  if (u >= domain.start - slack && u <= domain.end + slack) return std::clamp(u, domain.start, domain.end);
  throw InvalidShape(std::string(name) + " = " + text_of(u) + " is outside the domain [" + text_of(domain.start) +
                     ", " + text_of(domain.end) + "]");
}

/// @throws PointAtInfinity with a parameter of the range where the weight is zero.
void require_finite_points(const NurbsCurve& curve, const Interval& range) {
  if (!curve.rational()) return;
  for (const Interval& piece : pieces(curve)) {
    const double start = std::max(piece.start, range.start);
    const double end = std::min(piece.end, range.end);
    if (start > end) continue;
    if (start == piece.start && is_at_infinity(curve, start, Side::right)) throw PointAtInfinity(start);
    if (end == piece.end && is_at_infinity(curve, end, Side::left)) throw PointAtInfinity(end);
  }
}

/// A quarter of each part, so that no narrow peak falls between the first nodes.
std::vector<Cell<1>> cells_of(const NurbsCurve& curve, const Interval& range) {
  std::vector<Cell<1>> cells;
  for (const Interval& part : regular_parts(curve, range)) {
    for (const Cell<1>& half : quadrature::halves_of(Cell<1>{0, {part}})) {
      for (const Cell<1>& quarter : quadrature::halves_of(half)) cells.push_back(quarter);
    }
  }
  return cells;
}

/// The length of the first derivative at parameters inside one span, and the size of its terms.
class Speed {
 public:
  explicit Speed(const NurbsCurve& curve) : curve_(curve), at_(curve.knot_vector(), 1) {}

  Sum operator()(double u) {
    at_.move_to(u, Side::right);
    const glm::dvec4* points = curve_.homogeneous_points().data() + at_.first();
    const glm::dvec4 h = weighted_sum(at_.weights(0), points);
    const glm::dvec3 point = project(h);
    // Relative to the point, so that where the sum falls to zero, at a cusp, its terms do so, too.
    glm::dvec3 slope(0.0);
    double terms = 0.0;
    for (std::size_t j = 0; j < at_.weights(1).size(); ++j) {
      const glm::dvec3 there = points[j].w * point;
      const glm::dvec3 term = at_.weights(1)[j] * (glm::dvec3(points[j]) - there);
      slope += term;
      terms += glm::length(term) + std::abs(at_.weights(1)[j]) * glm::length(there);
    }
    return {glm::length(slope / h.w), terms / std::abs(h.w)};
  }

 private:
  const NurbsCurve& curve_;
  Stencil at_;
};

Approximation<double> length_inside(const NurbsCurve& curve, const Interval& range, double tolerance) {
  require_finite_points(curve, range);
  const Placement placement = placement_of(curve.points());
  const int exponent = scale_of(curve.knot_vector());
  const NurbsCurve placed_curve = placed(curve, placement);
  const NurbsCurve near = exponent == 0 ? placed_curve : divided(placed_curve, {.parameters = exponent});
  Speed speed(near);
  const auto rule = [&](const Cell<1>& cell) {
    const auto nodes = gauss_nodes(cell.box[0]);
    Sum sum;
    for (std::size_t i = 0; i < kGaussNodes; ++i) {
      const double weight = cell.box[0].length() * gauss_rule().weights[i];
      const Sum here = speed(nodes[i]);
      sum.value += weight * here.value;
      sum.magnitude += weight * here.magnitude;
    }
    return sum;
  };
  const auto cells = cells_of(near, {std::scalbn(range.start, -exponent), std::scalbn(range.end, -exponent)});
  const auto found = adaptive_integral(cells, rule, tolerance, kMostCells, "the length cannot be found");
  return {finite_size(found.value, 1, placement, "length"), given_size(found.error, 1, placement)};
}

/// Whole turns, and what is left of one, which may lie on both sides of the seam.
Approximation<double> length_around(const NurbsCurve& curve, const Interval& range, double tolerance) {
  const KnotVector& knots = curve.knot_vector();
  const Interval domain = curve.domain();
  const double start = knots.admit(range.start, Side::right, {}, "start");
  const double end = knots.admit(range.end, Side::left, {}, "end");
  if (range.start == range.end) return {0.0, 0.0};
  const auto part = [&](double from, double to) { return length_inside(curve, {from, to}, tolerance); };
  // Halves, because the distance itself may overflow.
  const double ways = (0.5 * range.end - 0.5 * range.start - (0.5 * end - 0.5 * start)) / (0.5 * domain.length());
  double turns = std::round(ways);
  Approximation<double> total{0.0, 0.0};
  const auto add = [&](double times, const Approximation<double>& more) {
    total.value += times * more.value;
    total.error += times * more.error;
  };
  if (start <= end) {
    add(1.0, part(start, end));
  } else {
    add(1.0, part(start, domain.end));
    add(1.0, part(domain.start, end));
    turns -= 1.0;
  }
  if (turns > 0.0) add(turns, part(domain.start, domain.end));
  if (!std::isfinite(total.value)) throw InvalidShape("the length is too large for a number");
  return total;
}

}  // namespace

Approximation<double> length(const NurbsCurve& curve, Interval range, double tolerance) {
  require_relative(tolerance);
  if (range.start > range.end) {
    throw InvalidShape("start = " + text_of(range.start) + " is above end = " + text_of(range.end));
  }
  if (curve.periodic()) return length_around(curve, range, tolerance);
  const Interval domain = curve.domain();
  return length_inside(curve, {admitted(range.start, domain, "start"), admitted(range.end, domain, "end")}, tolerance);
}

Approximation<double> length(const NurbsCurve& curve) { return length(curve, curve.domain()); }

}  // namespace splinecore
