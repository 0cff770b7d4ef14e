#include "normal.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

constexpr int kOrder = 3;
using Derivatives = std::array<glm::dvec3, (kOrder + 2) * (kOrder + 2)>;

double direction_inward(double u, const KnotVector& knots) {
  const Interval range = knots.domain();
  return knots.periodic() || u <= range.middle() ? range.length() : -range.length();
}

double factorial(int n) { return n <= 1 ? 1.0 : n * factorial(n - 1); }

double choose(int n, int k) { return factorial(n) / (factorial(k) * factorial(n - k)); }

/// (a d/du + b d/dv)^n of S_u or S_v, divided by n!.
glm::dvec3 along(const Derivatives& d, int n, double a, double b, int in_u, int in_v) {
  glm::dvec3 sum(0.0);
  for (int k = 0; k <= n; ++k) {
    double factor = choose(n, k) / factorial(n);
    for (int i = 0; i < k; ++i) factor *= a;
    for (int i = k; i < n; ++i) factor *= b;
    sum += factor * d[(k + in_u) * (kOrder + 2) + (n - k + in_v)];
  }
  return sum;
}

}  // namespace

NormalFinder::NormalFinder(const NurbsPatch& patch)
    : patch_(patch), range_u_(patch.knot_vector(Axis::u).domain()),
      range_v_(patch.knot_vector(Axis::v).domain()) {
  constexpr double kRelative = 1e-12;
  const double size = extent(patch.points());
  negligible_ = kRelative * (size / range_u_.length()) * (size / range_v_.length());
}

glm::dvec3 NormalFinder::at(double u, double v, const glm::dvec3& su, const glm::dvec3& sv,
                            PatchOptions options) const {
  const glm::dvec3 normal = glm::cross(su, sv);
  const double length = glm::length(normal);
  return length > negligible_ ? normal / length : limit(u, v, options);
}

/// S_u x S_v as a power series along a straight way into the domain: its first coefficient
/// that is not rounding is the direction of the limit.
glm::dvec3 NormalFinder::limit(double u, double v, PatchOptions options) const {
  Derivatives d;
  derivatives(patch_, {&u, 1}, {&v, 1}, kOrder + 1, {&d[0].x, 3 * d.size()}, options);
  const double a = direction_inward(u, patch_.knot_vector(Axis::u));
  const double b = direction_inward(v, patch_.knot_vector(Axis::v));
  for (int n = 0; n <= kOrder; ++n) {
    glm::dvec3 coefficient(0.0);
    for (int k = 0; k <= n; ++k) {
      coefficient += glm::cross(along(d, k, a, b, 1, 0), along(d, n - k, a, b, 0, 1));
    }
    const double length = glm::length(coefficient);
    if (length > negligible_) return coefficient / length;
  }
  return glm::dvec3(0.0);
}

}  // namespace splinecore
