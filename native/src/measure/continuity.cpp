#include "splinecore/measure/continuity.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/curve/evaluate.hpp"

namespace splinecore {

namespace {

/// One side of a joint.
struct End {
  std::vector<glm::dvec3> derivatives;
  std::vector<double> rounding;  ///< below which derivative k is none
  double sign = 1.0;             ///< -1 where the curve arrives: odd derivatives point backwards
};

End end_of(const NurbsCurve& curve, double u, Side side, int order) {
  constexpr double kRounding = 0x1p-44;
  End end;
  end.derivatives.resize(order + 1);
  derivatives(curve, {&u, 1}, order, std::span(&end.derivatives[0].x, 3 * (order + 1)), {.side = side});
  const KnotVector& knots = curve.knot_vector();
  const double span = knots.span_interval(knots.span_of(knots.admit(u, side), side)).length();
  double size = std::max(extent(curve.points()), kRounding * largest_coordinate(curve.points()));
  for (int k = 0; k <= order; ++k) {
    end.rounding.push_back(kRounding * size);
    size *= 2.0 * (curve.degree() + 1) / span;
  }
  end.rounding[0] = kRounding * std::max(size == 0.0 ? 0.0 : extent(curve.points()), largest_coordinate(curve.points()));
  end.sign = side == Side::left ? -1.0 : 1.0;
  return end;
}

/// The direction in which the curve goes on, and its curvature vector, as limits towards the joint.
struct Limit {
  glm::dvec3 direction{0.0};
  glm::dvec3 curvature{0.0};
  bool is_regular = false;  ///< the first derivative is not zero
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
  const double a = length(m) / factorial(m);
  for (int k = m + 1; k <= order; ++k) {
    const glm::dvec3 across = end.derivatives[k] - glm::dot(end.derivatives[k], limit.direction) * limit.direction;
    const double b = glm::length(across);
    if (b <= std::max(end.rounding[k], kContinuityTolerance * length(k))) continue;
    if (k == 2 * m) limit.curvature = 2.0 * across / factorial(k) / (a * a);
    if (k < 2 * m) limit.curvature = across / b * HUGE_VAL;
    break;
  }
  return limit;
}

int common_derivatives(const End& left, const End& right, double tolerance) {
  const int order = static_cast<int>(left.derivatives.size()) - 1;
  for (int k = 0; k <= order; ++k) {
    const double size = std::max(glm::length(left.derivatives[k]), glm::length(right.derivatives[k]));
    const double slack = k == 0 ? 0.0 : tolerance * size;
    const double rounding = std::max(left.rounding[k], right.rounding[k]);
    if (glm::length(right.derivatives[k] - left.derivatives[k]) > std::max(slack, rounding)) return k - 1;
  }
  return order;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Continuity compared(const End& left, const End& right, double tolerance) {
  const Limit before = limit_of(left);
  const Limit after = limit_of(right);
  Continuity found;
  found.gap = glm::length(right.derivatives[0] - left.derivatives[0]);
  found.angle = angle_between(before.direction, after.direction);
  found.curvature_difference = before.curvature == after.curvature ? 0.0 : glm::length(after.curvature - before.curvature);
  found.c = common_derivatives(left, right, tolerance);
  if (found.c < 0) return found;
  found.g = 0;
  if (!(found.angle <= std::sqrt(tolerance))) return found;
  found.g = 1;
  const double largest = std::max(glm::length(before.curvature), glm::length(after.curvature));
  if (!(found.curvature_difference <= std::sqrt(tolerance) * largest)) return found;
  found.g = before.is_regular && after.is_regular ? std::max(2, found.c) : 2;
  return found;
}

}  // namespace

Continuity continuity_at(const NurbsCurve& curve, double u, double tolerance) {
  const double at = curve.knot_vector().admit(u, Side::right);
  const Interval domain = curve.domain();
  if (!curve.periodic() && (at == domain.start || at == domain.end)) {
    throw InvalidShape("u = " + text_of(u) + " is an end of the curve");
  }
  const int order = std::min(std::max(curve.degree(), 2), kMaxOrder);
  const double before = at == domain.start ? domain.end : at;
  return compared(end_of(curve, before, Side::left, order), end_of(curve, at, Side::right, order), tolerance);
}

Continuity continuity_between(const NurbsCurve& a, const NurbsCurve& b, double tolerance) {
  const int order = std::min(std::max({a.degree(), b.degree(), 2}), kMaxOrder);
  return compared(end_of(a, a.domain().end, Side::left, order), end_of(b, b.domain().start, Side::right, order),
                  tolerance);
}

std::vector<Joint> joints(const NurbsCurve& curve, double tolerance) {
  std::vector<Joint> found;
  const Interval domain = curve.domain();
  const KnotVector& knots = curve.knot_vector();
  const auto add = [&](double u, auto measure) {
    try {
      found.push_back({u, measure()});
    } catch (const PointAtInfinity&) {
    }
  };
  for (std::size_t i = 0; i < knots.spans().size(); ++i) {
    const double u = knots.span_interval(static_cast<int>(i)).start;
    if (u > domain.start || curve.periodic()) add(u, [&] { return continuity_at(curve, u, tolerance); });
  }
  if (!curve.periodic()) {
    add(domain.start, [&] { return continuity_between(curve, curve, tolerance); });
    if (!found.empty() && found.back().u == domain.start && found.back().continuity.c < 0) found.pop_back();
  }
  return found;
}

}  // namespace splinecore
