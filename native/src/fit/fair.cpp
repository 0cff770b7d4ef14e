#include "splinecore/fit/fair.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "curve/rescale.hpp"
#include "fairest.hpp"
#include "fitted_points.hpp"
#include "least_squares_fit.hpp"
#include "quadrature_nodes.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

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

/// Spans in which bending is not counted: beside the mean one they are so short that beside their numbers nothing would be
/// left of others. The curve hardly goes on there, or what it does is like a corner.
double shortest_in(const KnotVector& knots) {
  constexpr double kShortest = 0x1p-12;
  return kShortest * knots.domain().length() / static_cast<double>(knots.spans().size());
}

/// Fairs by a factor of the energy that is a power of two.
class Fairing {
 public:
  Fairing(const NurbsCurve& curve, KeptEnds ends)
      : curve_(curve), knots_(near_one(curve.knot_vector()).knots), held_(held_of(knots_, ends)),
        nodes_(quadrature_nodes(breaks_of(knots_, knots_), knots_.degree() + 1, false)) {
    double largest = 0.0;
    for (const glm::dvec4& point : curve.points()) {
      for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(point[c]));
    }
    exponent_ = largest > 0.0 ? std::ilogb(largest) : 0;
    const auto near = [&](const glm::dvec4& point, int c) { return std::ldexp(point[c], -exponent_); };
    std::vector<glm::dvec4> plain;
    for (const glm::dvec4& point : curve.points()) {
      for (int c = 0; c < 3; ++c) controls_.push_back(near(point, c) - near(curve.points().front(), c));
      plain.emplace_back(glm::make_vec3(controls_.data() + controls_.size() - 3), 1.0);
    }
    values_.resize(3 * nodes_.parameters.size());
    evaluate(NurbsCurve::make(knots_, std::move(plain)), nodes_.parameters, std::span(values_));
  }

  /// @returns nothing where the energy outweighs the distance by more than numbers can tell
  std::optional<Approximation<NurbsCurve>> faired(double exponent) const {
    const double factor = std::exp2(exponent) * std::pow(knots_.domain().length(), 3);
    std::vector<double> controls = controls_;
    try {
      const LeastSquaresFit fit(knots_, nodes_.parameters, nodes_.weights, factor, held_, shortest_in(knots_));
      fit.solve_points(values_, controls);
    } catch (const InvalidShape&) {
      return {};
    }
    std::vector<glm::dvec4> points(curve_.points().begin(), curve_.points().end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        const std::size_t at = 3 * i + static_cast<std::size_t>(c);
        points[i][c] += std::ldexp(controls[at] - controls_[at], exponent_);
      }
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
  int exponent_ = 0;   // the largest coordinate is near 2 to this power; what follows is divided by it, from the first point
  std::vector<double> controls_;
  std::vector<double> values_;
};

}  // namespace

Approximation<NurbsCurve> fair(const NurbsCurve& curve, double tolerance, KeptEnds ends) {
  require_positive(tolerance);
  require_curve(curve);
  const Fairing fairing(curve, ends);
  auto best = fairest(curve, tolerance, [&](double exponent) { return fairing.faired(exponent); });
  if (best) return *std::move(best);
  throw InvalidShape("the curve cannot be faired as far as numbers can tell: its degree is too high, or "
                     "knots lie too near each other");
}

}  // namespace splinecore
