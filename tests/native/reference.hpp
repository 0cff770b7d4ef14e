#pragma once

#include <cmath>
#include <glm/ext/vector_common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "splinecore/curve/nurbs_curve.hpp"

/// Second implementations, straight from the definitions and in long double.
namespace splinecore::testing {

using Real = long double;
using Point = glm::vec<4, Real>;

/// N_{i,p}(u) by the recursion of Cox and de Boor; spans closed on the left, or on the right.
inline Real cox_de_boor(std::span<const Real> t, int i, int p, Real u, Side side = Side::right) {
  if (p == 0) {
    const bool inside = side == Side::right ? t[i] <= u && u < t[i + 1] : t[i] < u && u <= t[i + 1];
    return inside ? 1.0L : 0.0L;
  }
  const Real rise = t[i + p] - t[i];
  const Real fall = t[i + p + 1] - t[i + 1];
  Real sum = 0.0L;
  if (rise > 0.0L) sum += (u - t[i]) / rise * cox_de_boor(t, i, p - 1, u, side);
  if (fall > 0.0L) sum += (t[i + p + 1] - u) / fall * cox_de_boor(t, i + 1, p - 1, u, side);
  return sum;
}

/// Derivative k of N_{i,p}, by the derivative of the recursion.
inline Real derivative(std::span<const Real> t, int i, int p, int k, Real u, Side side = Side::right) {
  if (k == 0) return cox_de_boor(t, i, p, u, side);
  if (p == 0) return 0.0L;
  const Real rise = t[i + p] - t[i];
  const Real fall = t[i + p + 1] - t[i + 1];
  Real sum = 0.0L;
  if (rise > 0.0L) sum += p / rise * derivative(t, i, p - 1, k - 1, u, side);
  if (fall > 0.0L) sum -= p / fall * derivative(t, i + 1, p - 1, k - 1, u, side);
  return sum;
}

/// Knots as far as the domain needs them: knot i of a period, with `degree` more on each side.
inline std::vector<Real> all_knots(const KnotVector& knots) {
  const auto given = knots.knots();
  std::vector<Real> all(given.begin(), given.end());
  if (!knots.periodic()) return all;
  const Real period = static_cast<Real>(given.back()) - given.front();
  const std::size_t count = given.size() - 1;
  for (int i = 0; i < knots.degree(); ++i) all.push_back(all[all.size() - count] + period);
  for (int i = 0; i < knots.degree(); ++i) all.insert(all.begin(), all[count - 1] - period);
  return all;
}

/// Of derivative k of all functions: what rounding is relative to.
inline double sum_of_sizes(const KnotVector& knots, int k, Real u) {
  const std::vector<Real> all = all_knots(knots);
  Real sum = 0.0L;
  for (int i = 0; i < knots.unrolled_count(); ++i) sum += std::abs(derivative(all, i, knots.degree(), k, u));
  return static_cast<double>(sum);
}

/// Derivative k of the homogeneous curve at a parameter of its domain.
inline Point homogeneous_derivative(const NurbsCurve& curve, int k, Real u, Side side = Side::right) {
  const std::vector<Real> t = all_knots(curve.knot_vector());
  const int p = curve.degree();
  if (u >= t[t.size() - 1 - p]) side = Side::left;
  if (u <= t[p]) side = Side::right;
  const int count = static_cast<int>(t.size()) - p - 1;
  Point sum(0.0L);
  for (int i = 0; i < count; ++i) {
    if (u < t[i] || u > t[i + p + 1]) continue;
    const Point given(curve.points()[i % curve.points().size()]);
    const Real weight = given.w == 0.0L ? 1.0L : given.w;
    sum += derivative(t, i, p, k, u, side) * Point(weight * glm::vec<3, Real>(given), given.w);
  }
  return sum;
}

/// Both halves of de Casteljau's triangle for the homogeneous points at t.
struct Triangle {
  std::vector<Point> left;
  std::vector<Point> right;
};

inline Triangle de_casteljau(std::vector<Point> points, Real t) {
  Triangle triangle;
  while (!points.empty()) {
    triangle.left.push_back(points.front());
    triangle.right.insert(triangle.right.begin(), points.back());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = (1.0L - t) * points[i] + t * points[i + 1];
    points.pop_back();
  }
  return triangle;
}

inline std::vector<Point> long_homogeneous(std::span<const glm::dvec4> given) {
  std::vector<Point> points;
  for (const glm::dvec4& p : given) {
    const Real weight = p.w == 0.0 ? 1.0 : p.w;
    points.emplace_back(weight * p.x, weight * p.y, weight * p.z, p.w);
  }
  return points;
}

}  // namespace splinecore::testing
