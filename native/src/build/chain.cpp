#include "splinecore/build/chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/length.hpp"
#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/hermite.hpp"

namespace splinecore {

namespace {

using Vector = glm::dvec3;

/// The point that divides from a to b as weight_b to weight_a: affine whatever the rounding.
Vector between(const Vector& a, double weight_a, const Vector& b, double weight_b) {
  const double total = weight_a + weight_b;
  return (weight_a / total) * a + (weight_b / total) * b;
}

BezierCurve cubic(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  return BezierCurve::make({{a, 1.0}, {b, 1.0}, {c, 1.0}, {d, 1.0}});
}

/// The two inner points of an arc.
struct Inner {
  Vector f;
  Vector g;
};

/// Of arc i, from 0; h are the lengths of the intervals and d the polygon. The lectures' h_{i+3} is h[i].
Inner inner_points(std::span<const Vector> d, std::span<const double> h, std::size_t i) {
  const std::size_t last = h.size() - 1;
  if (last == 0) return {d[1], d[2]};
  if (i == 0) return {d[1], between(d[1], h[1], d[2], h[0])};
  if (i == last) return {between(d[i + 1], h[i], d[i + 2], h[i - 1]), d[i + 2]};
  return {between(d[i + 1], h[i] + h[i + 1], d[i + 2], h[i - 1]), between(d[i + 1], h[i + 1], d[i + 2], h[i - 1] + h[i])};
}

std::vector<double> lengths_of(std::span<const double> parameters) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < parameters.size(); ++i) lengths.push_back(parameters[i] - parameters[i - 1]);
  return lengths;
}

void require_cubic(const BezierCurve& curve, std::size_t i) {
  const std::string name = "chain" + index_text(i);
  if (curve.degree() != 3) throw InvalidShape(name + " has degree " + std::to_string(curve.degree()) + ", not 3");
  if (curve.nurbs().rational()) throw InvalidShape(name + " is rational: the polygon is that of a polynomial chain");
}

Vector point_of(const BezierCurve& curve, int i) { return Vector(curve.points()[i]); }

/// Where two curves of a chain meet, on intervals of lengths a and b.
struct ChainJoint {
  const BezierCurve& q;
  const BezierCurve& r;
  double a;
  double b;

  Vector apex_before() const { return point_of(q, 2) + (b / a) * (point_of(q, 2) - point_of(q, 1)); }
  Vector apex_after() const { return point_of(r, 1) + (a / b) * (point_of(r, 1) - point_of(r, 2)); }
  /// From the side that prolongs its leg by less.
  Vector apex() const { return b <= a ? apex_before() : apex_after(); }
};

void require_c2(const ChainJoint& joint, std::size_t number, std::optional<double> tolerance) {
  constexpr double kRounding = 1e-12;
  const double size = std::max(largest_coordinate(joint.q.points()), largest_coordinate(joint.r.points()));
  const double ratio = std::max(joint.a / joint.b, joint.b / joint.a);
  const auto [q, r, a, b] = joint;
  const std::array<double, 3> gaps{distance_of(point_of(q, 3), point_of(r, 0)),
                                   distance_of(between(point_of(q, 2), b, point_of(r, 1), a), point_of(q, 3)),
                                   distance_of(joint.apex_before(), joint.apex_after())};
  for (int order = 0; order < 3; ++order) {
    const double allowed = tolerance.value_or(kRounding * size * (order == 2 ? 1.0 + ratio : 1.0));
    if (gaps[order] <= allowed) continue;
    throw InvalidShape("joint " + std::to_string(number) + " is not C" + std::to_string(order) + ": two places that " +
                       "should be one lie " + text_of(gaps[order]) + " apart");
  }
}

void require_lengths(std::span<const double> lengths, std::size_t count) {
  if (lengths.size() != count) {
    throw InvalidShape("lengths has " + std::to_string(lengths.size()) + " values for " + std::to_string(count) +
                       " curves");
  }
  for (std::size_t i = 0; i < count; ++i) require_positive(lengths[i], "lengths" + index_text(i));
}

}  // namespace

std::vector<BezierCurve> chain_from_polygon(std::span<const glm::dvec3> points, std::vector<double> parameters) {
  if (points.size() < 4) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, a cubic chain needs 4 or more");
  }
  require_finite(points, "points");
  parameters = hermite_parameters(std::move(parameters), points.size() - 2, "parameters");
  const std::vector<double> h = lengths_of(parameters);
  std::vector<BezierCurve> chain;
  Vector start = points.front();
  for (std::size_t i = 0; i < h.size(); ++i) {
    const auto [f, g] = inner_points(points, h, i);
    const bool is_last = i + 1 == h.size();
    const Vector end = is_last ? points.back() : between(g, h[i + 1], inner_points(points, h, i + 1).f, h[i]);
    chain.push_back(cubic(start, f, g, end));
    start = end;
  }
  return chain;
}

std::vector<glm::dvec3> polygon_of_chain(std::span<const BezierCurve> chain, std::vector<double> lengths,
                                         std::optional<double> tolerance) {
  if (chain.empty()) throw InvalidShape("chain is empty: it needs one curve or more");
  for (std::size_t i = 0; i < chain.size(); ++i) require_cubic(chain[i], i);
  if (lengths.empty()) lengths.assign(chain.size(), 1.0);
  require_lengths(lengths, chain.size());
  if (tolerance) require_tolerance(*tolerance);
  std::vector<Vector> polygon{point_of(chain.front(), 0), point_of(chain.front(), 1)};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const ChainJoint joint{chain[i - 1], chain[i], lengths[i - 1], lengths[i]};
    require_c2(joint, i, tolerance);
    polygon.push_back(joint.apex());
  }
  polygon.push_back(point_of(chain.back(), 2));
  polygon.push_back(point_of(chain.back(), 3));
  return polygon;
}

std::pair<BezierCurve, BezierCurve> c2_pair(const glm::dvec3& q0, const glm::dvec3& q1, const glm::dvec3& d,
                                            const glm::dvec3& r2, const glm::dvec3& r3, double a, double b) {
  require_positive(a, "a");
  require_positive(b, "b");
  const std::pair<const char*, const Vector&> kPlaces[]{{"q0", q0}, {"q1", q1}, {"d", d}, {"r2", r2}, {"r3", r3}};
  for (const auto& [name, place] : kPlaces) require_finite(std::span(&place.x, 3), name);
  const Vector q2 = between(q1, b, d, a);
  const Vector r1 = between(d, b, r2, a);
  const Vector joint = between(q2, b, r1, a);
  return {cubic(q0, q1, q2, joint), cubic(joint, r1, r2, r3)};
}

}  // namespace splinecore
