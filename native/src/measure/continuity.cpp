#include "splinecore/measure/continuity.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/angle.hpp"
#include "base/quotient.hpp"
#include "base/require.hpp"
#include "curve/rescale.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// One side of a joint.
struct End {
  std::vector<glm::dvec3> derivatives;
  std::vector<double> rounding;  ///< below which derivative k is none
  double sign = 1.0;             ///< -1 where the curve arrives: odd derivatives point backwards
};

/// What rounding is relative to, for a whole curve.
struct Sizes {
  double coordinate;
  double weight;
};

Sizes sizes_of(const NurbsCurve& curve) {
  Sizes sizes{largest_coordinate(curve.points()), 0.0};
  for (const glm::dvec4& p : curve.homogeneous_points()) sizes.weight = std::max(sizes.weight, std::abs(p.w));
  return sizes;
}

/// How far rounding may move each derivative: the quotient rule once more, on the errors of what goes in.
std::vector<double> roundings(const NurbsCurve& curve, double u, Side side, const std::vector<glm::dvec3>& values,
                              const Sizes& sizes) {
  constexpr double kRounding = 0x1p-49;
  const int order = static_cast<int>(values.size()) - 1;
  Stencil at(curve.knot_vector(), order);
  at.move_to(curve.knot_vector().admit(u, side), side);
  const auto points = curve.homogeneous_points().subspan(at.first(), at.weights(0).size());
  double largest = 0.0;
  for (const glm::dvec4& p : points) largest = std::max(largest, glm::length(glm::dvec3(p)));
  std::vector<double> weights;
  std::vector<double> errors;
  std::vector<double> roundings;
  for (int k = 0; k <= order; ++k) {
    double sum = 0.0;
    for (const double weight : at.weights(k)) sum += std::abs(weight);
    errors.push_back(kRounding * sum);
    weights.push_back(std::abs(weighted_sum(at.weights(k), points.data()).w));
    double rounding = errors[k] * largest + errors[0] * sizes.weight * glm::length(values[k]);
    double choose = 1.0;
    for (int i = 1; i <= k && curve.rational(); ++i) {
      choose *= static_cast<double>(k - i + 1) / i;
      rounding += choose * (weights[i] * roundings[k - i] + errors[i] * sizes.weight * glm::length(values[k - i]));
    }
    roundings.push_back(rounding / weights[0]);
  }
  return roundings;
}

void require_in_sight(const NurbsCurve& curve, double u, Side side) {
  if (is_at_infinity(curve, u, side)) throw PointAtInfinity(u);
}

End end_of(const NurbsCurve& curve, double u, Side side, int order, const Sizes& sizes) {
  constexpr double kGap = 0x1p-44;
  require_in_sight(curve, u, side);
  End end;
  end.derivatives.resize(order + 1);
  derivatives(curve, {&u, 1}, order, std::span(&end.derivatives[0].x, 3 * (order + 1)), {side, AtInfinity::nan});
  if (!is_finite(end.derivatives[0])) throw PointAtInfinity(u);
  // On a tiny span high derivatives leave the range of numbers: they tell nothing.
  const auto is_out_of_range = [](const glm::dvec3& p) { return !is_finite(p) || !std::isfinite(glm::length(p)); };
  end.derivatives.erase(std::find_if(end.derivatives.begin() + 1, end.derivatives.end(), is_out_of_range),
                        end.derivatives.end());
  end.rounding = roundings(curve, u, side, end.derivatives, sizes);
  end.rounding[0] = std::max(end.rounding[0], kGap * sizes.coordinate);
  end.sign = side == Side::left ? -1.0 : 1.0;
  return end;
}

/// The direction in which the curve goes on, and its curvature vector, as limits towards the joint.
struct Limit {
  glm::dvec3 direction{0.0};
  glm::dvec3 curvature{0.0};
  bool is_regular = false;  ///< the first derivative is not zero
  bool is_bent = false;     ///< the curvature grows beyond all bounds
  double turn = 0.0;        ///< how far rounding may turn the direction, an angle
  double bend = 0.0;        ///< how far it may move the curvature
};

double factorial(int n) { return std::tgamma(n + 1.0); }

/// With the first derivative that is not zero, of order m, the curve runs as a s^m along its direction;
/// the first that leaves this line, of order k, decides the curvature: y = b s^k = b (x / a)^(k / m).
Limit limit_of(const End& end) {
  const int order = static_cast<int>(end.derivatives.size()) - 1;
  const auto length = [&](int k) { return glm::length(end.derivatives[k]); };
  Limit limit;
  int m = 1;
  while (m <= order && length(m) <= end.rounding[m]) ++m;
  if (m > order) return limit;
  limit.is_regular = m == 1;
  // Arriving at s = 0 from below, s^m has the sign (-1)^m, and the curve moves against it.
  const double forward = end.sign < 0.0 && m % 2 == 0 ? -1.0 : 1.0;
  limit.direction = forward * end.derivatives[m] / length(m);
  limit.turn = end.rounding[m] / length(m);
  const double a = length(m) / factorial(m);
  if (2 * m <= order) {
    limit.bend = 2.0 * (end.rounding[2 * m] + 2.0 * length(2 * m) * limit.turn) / factorial(2 * m) / (a * a);
  }
  for (int k = m + 1; k <= order; ++k) {
    const glm::dvec3 across = end.derivatives[k] - glm::dot(end.derivatives[k], limit.direction) * limit.direction;
    const double b = glm::length(across);
    if (b <= std::max(end.rounding[k], kContinuityTolerance * length(k))) continue;
    if (k == 2 * m) limit.curvature = 2.0 * across / factorial(k) / (a * a);
    limit.is_bent = k < 2 * m;
    break;
  }
  return limit;
}

int common_derivatives(const End& left, const End& right, double tolerance) {
  const int order = static_cast<int>(std::min(left.derivatives.size(), right.derivatives.size())) - 1;
  for (int k = 0; k <= order; ++k) {
    const double size = std::max(glm::length(left.derivatives[k]), glm::length(right.derivatives[k]));
    const double slack = k == 0 ? 0.0 : tolerance * size;
    const double rounding = std::max(left.rounding[k], right.rounding[k]);
    if (glm::length(right.derivatives[k] - left.derivatives[k]) > std::max(slack, rounding)) return k - 1;
  }
  return order;
}

/// What of point, direction and curvature two ends have in common: 0, 1 or 2.
int common_shape(const Limit& before, const Limit& after, const Continuity& found, double tolerance) {
  const auto rests = [](const Limit& limit) { return limit.direction == glm::dvec3(0.0); };
  if (rests(before) != rests(after) || !(found.angle <= std::max(tolerance, before.turn + after.turn))) return 0;
  const double largest = std::max(glm::length(before.curvature), glm::length(after.curvature));
  const bool is_as_bent = found.curvature_difference <= std::max(tolerance * largest, before.bend + after.bend);
  return is_as_bent ? 2 : 1;
}

Continuity compared(const End& left, const End& right, int degree, double tolerance) {
  const Limit before = limit_of(left);
  const Limit after = limit_of(right);
  Continuity found;
  found.gap = glm::length(right.derivatives[0] - left.derivatives[0]);
  found.angle = angle_between(before.direction, after.direction);
  const bool is_bent = before.is_bent || after.is_bent;
  found.curvature_difference = is_bent ? HUGE_VAL : glm::length(after.curvature - before.curvature);
  found.c = std::min(common_derivatives(left, right, tolerance), degree);
  if (found.c < 0) return found;
  found.g = common_shape(before, after, found, tolerance);
  if (before.is_regular && after.is_regular) found.g = std::max(found.g, found.c);
  return found;
}

int order_for(int degree) { return std::min(std::max(degree, 2), kMaxOrder); }

/// A curve brought to the size of one, and what rounding is relative to on it.
struct Measured {
  NurbsCurve curve;
  Sizes sizes;
  Scales scales;

  Measured(const NurbsCurve& given, const Scales& by) : curve(divided(given, by)), sizes(sizes_of(curve)), scales(by) {}
  explicit Measured(const NurbsCurve& given) : Measured(given, scales_of(given)) {}

  /// Lengths in the units of the given curve.
  Continuity in_units(Continuity found) const {
    found.gap = std::scalbn(found.gap, scales.coordinates);
    found.curvature_difference = std::scalbn(found.curvature_difference, -scales.coordinates);
    return found;
  }
};

Continuity at_parameter(const Measured& on, double u, double tolerance) {
  const Interval domain = on.curve.domain();
  const int order = order_for(on.curve.degree());
  const double before = u == domain.start ? domain.end : u;
  return on.in_units(compared(end_of(on.curve, before, Side::left, order, on.sizes),
                              end_of(on.curve, u, Side::right, order, on.sizes), on.curve.degree(), tolerance));
}

Continuity between(const Measured& a, const Measured& b, double tolerance) {
  const int degree = std::max(a.curve.degree(), b.curve.degree());
  const int order = order_for(degree);
  return a.in_units(compared(end_of(a.curve, a.curve.domain().end, Side::left, order, a.sizes),
                             end_of(b.curve, b.curve.domain().start, Side::right, order, b.sizes), degree, tolerance));
}

}  // namespace

Continuity continuity_at(const NurbsCurve& curve, double u, double tolerance) {
  require_tolerance(tolerance);
  const double at = curve.knot_vector().admit(u, Side::right);
  const Interval domain = curve.domain();
  if (!curve.periodic() && (at == domain.start || at == domain.end)) {
    throw InvalidShape("u = " + text_of(u) + " is an end of the curve");
  }
  require_in_sight(curve, at == domain.start ? domain.end : at, Side::left);
  require_in_sight(curve, at, Side::right);
  const Measured on(curve);
  return at_parameter(on, std::scalbn(at, -on.scales.parameters), tolerance);
}

Continuity continuity_between(const NurbsCurve& a, const NurbsCurve& b, double tolerance) {
  require_tolerance(tolerance);
  require_in_sight(a, a.domain().end, Side::left);
  require_in_sight(b, b.domain().start, Side::right);
  const Scales of_a = shared_scales(a, b);
  const Scales of_b = shared_scales(b, a);
  return between(Measured(a, of_a), Measured(b, of_b), tolerance);
}

std::vector<Joint> joints(const NurbsCurve& curve, double tolerance) {
  require_tolerance(tolerance);
  std::vector<Joint> found;
  const Measured on(curve);
  const KnotVector& knots = curve.knot_vector();
  const KnotVector& divided_knots = on.curve.knot_vector();
  const Interval domain = curve.domain();
  const auto add = [&](double u, auto measure) {
    try {
      found.push_back({u, measure()});
    } catch (const PointAtInfinity&) {
    }
  };
  for (int i = 0; i < static_cast<int>(knots.spans().size()); ++i) {
    const double u = knots.span_interval(i).start;
    const double at = divided_knots.span_interval(i).start;
    if (u > domain.start || curve.periodic()) add(u, [&] { return at_parameter(on, at, tolerance); });
  }
  if (!curve.periodic()) {
    add(domain.start, [&] { return between(on, on, tolerance); });
    if (!found.empty() && found.back().u == domain.start && found.back().continuity.c < 0) found.pop_back();
  }
  return found;
}

}  // namespace splinecore
