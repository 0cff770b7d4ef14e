#include "splinecore/fit/rebuild.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/require.hpp"
#include "build/fit_options.hpp"
#include "control_counts.hpp"
#include "curve/common_origin.hpp"
#include "fitted_points.hpp"
#include "quadrature_nodes.hpp"
#include "rebuilt_on.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/curve/distance.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

std::vector<glm::dvec3> slope_at(const NurbsCurve& curve, double u, Side side) {
  double values[6];
  derivatives(curve, {&u, 1}, 1, values, {.side = side});
  return {glm::dvec3(values[3], values[4], values[5])};
}

}  // namespace

Approximation<NurbsCurve> rebuilt_on(const NurbsCurve& curve, const KnotVector& knots, KeptEnds ends) {
  const bool is_open = !curve.periodic();
  const int degree = knots.degree();
  const auto breaks = breaks_of(curve.knot_vector(), knots);
  QuadratureNodes nodes = quadrature_nodes(breaks, node_count(curve.degree(), degree, curve.rational()), is_open);
  std::vector<glm::dvec3> points(nodes.parameters.size());
  evaluate(curve, nodes.parameters, {&points.front().x, 3 * points.size()});
  ApproximationOptions options;
  options.weights = nodes.weights;
  if (is_open && ends == KeptEnds::tangents && degree > 1) {
    // Far from the origin weights that change fast would leave few digits of them.
    const NurbsCurve near = curve.with_points(from_origin(curve.points(), common_origin(curve.points(), {})));
    options.start = slope_at(near, curve.domain().start, Side::right);
    options.end = slope_at(near, curve.domain().end, Side::left);
  }
  NurbsCurve made = fitted_points(points, nodes.parameters, knots, options).curve();
  const double error = largest_distance(curve, made);
  if (!std::isfinite(error)) throw InvalidShape("a curve that runs to infinity cannot be rebuilt");
  return {std::move(made), error};
}

Approximation<NurbsCurve> rebuild(const NurbsCurve& curve, int degree, std::size_t count, KeptEnds ends) {
  return rebuilt_on(curve, even_knots(degree, count, curve.domain(), curve.periodic()), ends);
}

Approximation<NurbsCurve> rebuild_within(const NurbsCurve& curve, int degree, double tolerance, std::size_t most,
                                         KeptEnds ends) {
  require_positive(tolerance);
  const std::size_t held = curve.periodic() ? 0 : ends == KeptEnds::tangents && degree > 1 ? 4 : 2;
  require_count(most, degree, curve.periodic());
  require_room_for_ends(most, held);
  std::size_t low = std::max(least_count(degree, curve.periodic()), held) - 1;
  std::size_t high = low + 1;
  Approximation<NurbsCurve> best = rebuild(curve, degree, high, ends);
  while (best.error > tolerance) {
    if (high >= most) {
      throw ToleranceNotReached("the curve cannot be rebuilt with " + std::to_string(most) + " control points",
                                tolerance, best.error);
    }
    low = high;
    high = std::min(most, 2 * high);
    best = rebuild(curve, degree, high, ends);
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    auto made = rebuild(curve, degree, middle, ends);
    if (made.error <= tolerance) {
      high = middle;
      best = std::move(made);
    } else {
      low = middle;
    }
  }
  return best;
}

}  // namespace splinecore
