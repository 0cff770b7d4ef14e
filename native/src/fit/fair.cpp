#include "splinecore/fit/fair.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "build/fit_options.hpp"
#include "curve/rescale.hpp"
#include "fitted_points.hpp"
#include "least_squares_fit.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

void require_curve(const NurbsCurve& curve) {
  if (curve.degree() < 2) throw InvalidShape("a curve of degree 1 has nothing to be faired: it is straight between knots");
  const auto points = curve.points();
  const bool is_positive = points.front().w > 0.0;
  for (const glm::dvec4& point : points) {
    if (is_positive ? point.w > 0.0 : point.w < 0.0) continue;
    throw InvalidShape("weights of both signs, or zero: a curve that may run to infinity cannot be faired");
  }
}

Held held_of(const KnotVector& knots, KeptEnds ends) {
  if (knots.periodic()) return {};
  const auto chain = knots.knots();
  const auto degree = static_cast<std::size_t>(knots.degree());
  const std::size_t wanted = ends == KeptEnds::tangents ? 2 : 1;
  const bool is_clamped_at_start = chain[0] == chain[degree] || chain[1] == chain[degree];
  const bool is_clamped_at_end = chain[chain.size() - 2] == chain[chain.size() - 1 - degree];
  Held held{is_clamped_at_start ? wanted : degree, is_clamped_at_end ? wanted : degree};
  const auto count = static_cast<std::size_t>(knots.count());
  held.start = std::min(held.start, count);
  held.end = std::min(held.end, count - held.start);
  return held;
}

/// Fairs by a factor of the energy that is a power of two.
class Fairing {
 public:
  Fairing(const NurbsCurve& curve, KeptEnds ends)
      : curve_(curve), knots_(near_one(curve.knot_vector()).knots), held_(held_of(knots_, ends)),
        nodes_(quadrature_nodes(breaks_of(knots_, knots_), knots_.degree() + 1, false)) {
    for (const glm::dvec4& point : curve.points()) controls_.insert(controls_.end(), {point.x, point.y, point.z});
    std::vector<glm::dvec4> plain;
    for (const glm::dvec4& point : curve.points()) plain.emplace_back(glm::dvec3(point), 1.0);
    values_.resize(3 * nodes_.parameters.size());
    evaluate(NurbsCurve::make(knots_, std::move(plain)), nodes_.parameters, std::span(values_));
  }

  /// @returns nothing where the energy outweighs the distance by more than numbers can tell
  std::optional<Approximation<NurbsCurve>> faired(double exponent) const {
    const double factor = std::exp2(exponent) * std::pow(knots_.domain().length(), 3);
    const LeastSquaresFit fit(knots_, nodes_.parameters, nodes_.weights, {factor, 2}, held_);
    std::vector<double> controls = controls_;
    try {
      fit.solve(values_, 3, controls);
    } catch (const InvalidShape&) {
      return {};
    }
    std::vector<glm::dvec4> points(curve_.points().begin(), curve_.points().end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = {controls[3 * i], controls[3 * i + 1], controls[3 * i + 2], points[i].w};
    }
    NurbsCurve made = curve_.with_points(std::move(points));
    const double error = largest_distance(curve_, made);
    return Approximation<NurbsCurve>{std::move(made), error};
  }

 private:
  const NurbsCurve& curve_;
  KnotVector knots_;
  Held held_;
  QuadratureNodes nodes_;
  std::vector<double> controls_;
  std::vector<double> values_;
};

}  // namespace

Approximation<NurbsCurve> fair(const NurbsCurve& curve, double tolerance, KeptEnds ends) {
  require_tolerance(tolerance);
  require_curve(curve);
  constexpr double kWeakest = -70.0;
  constexpr double kStrongest = 10.0;
  constexpr double kNear = 0.125;
  const Fairing fairing(curve, ends);
  Approximation<NurbsCurve> best{curve, 0.0};
  double low = kWeakest;
  double high = kStrongest + kNear;
  for (double middle = kStrongest; high - low > kNear; middle = 0.5 * (low + high)) {
    auto made = fairing.faired(middle);
    if (made && made->error <= tolerance) {
      best = *std::move(made);
      low = middle;
    } else {
      high = middle;
    }
  }
  return best;
}

}  // namespace splinecore
