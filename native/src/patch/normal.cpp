#include "normal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

/// Terms of a power series along a way into the domain.
constexpr int kTerms = 4;
template <class Value>
using Series = std::array<Value, kTerms>;

/// Homogeneous derivatives around one pair of parameters, of the patch moved so that its point
/// there is the origin: no digits are lost far from the origin, and no division spreads rounding.
struct LocalDerivatives {
  static constexpr int kWidth = kTerms + 1;
  std::array<glm::dvec4, kWidth * kWidth> values;
  /// Largest offset from the point, coordinate and weight among the control points.
  double offset = 0.0;
  double coordinate = 0.0;
  double weight = 0.0;
};

LocalDerivatives local_derivatives(const NurbsPatch& patch, const Samples& u, const Samples& v) {
  const std::size_t width = patch.knot_vector(Axis::v).unrolled_count();
  const glm::dvec4* corner = patch.homogeneous_points().data() + u.first(0) * width + v.first(0);
  LocalDerivatives local;
  const auto sum = [&](int k, int l) {
    glm::dvec4 total(0.0);
    for (std::size_t i = 0; i < u.weights(0).size(); ++i) {
      total += u.weights(0, k)[i] * weighted_sum(v.weights(0, l), corner + i * width);
    }
    return total;
  };
  const glm::dvec3 origin = project(sum(0, 0));
  const auto moved = [&](const glm::dvec4& p) { return glm::dvec4(glm::dvec3(p) - p.w * origin, p.w); };
  for (int k = 0; k < local.kWidth; ++k) {
    for (int l = 0; l < local.kWidth; ++l) local.values[k * local.kWidth + l] = moved(sum(k, l));
  }
  for (std::size_t i = 0; i < u.weights(0).size(); ++i) {
    for (std::size_t j = 0; j < v.weights(0).size(); ++j) {
      const glm::dvec4& p = corner[i * width + j];
      local.offset = std::max(local.offset, glm::length(glm::dvec3(moved(p))));
      local.coordinate = std::max(local.coordinate, glm::length(glm::dvec3(p)));
      local.weight = std::max(local.weight, std::abs(p.w));
    }
  }
  return local;
}

/// The derivative in_u, in_v along the way (a, b) from the point.
Series<glm::dvec4> along(const LocalDerivatives& local, double a, double b, int in_u, int in_v) {
  Series<glm::dvec4> series;
  double factorial = 1.0;
  for (int n = 0; n < kTerms; ++n, factorial *= n) {
    series[n] = glm::dvec4(0.0);
    for (int k = 0; k <= n; ++k) {
      const double factor = binomial(n, k) / factorial * std::pow(a, k) * std::pow(b, n - k);
      series[n] += factor * local.values[(k + in_u) * local.kWidth + (n - k + in_v)];
    }
  }
  return series;
}

/// Adds w (x x y) to a series of normals.
void add_product(Series<glm::dvec3>& sum, const Series<glm::dvec4>& w, const Series<glm::dvec4>& x,
                 const Series<glm::dvec4>& y) {
  for (int i = 0; i < kTerms; ++i) {
    for (int j = 0; i + j < kTerms; ++j) {
      const glm::dvec3 normal = glm::cross(glm::dvec3(x[i]), glm::dvec3(y[j]));
      for (int k = 0; i + j + k < kTerms; ++k) sum[i + j + k] += w[k].w * normal;
    }
  }
}

/// With its largest coordinate about 1, by a power of two.
glm::dvec3 scaled(const glm::dvec3& vector) {
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  if (!(largest > 0.0) || !is_finite(vector)) return glm::dvec3(0.0);
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(vector.x, exponent), std::ldexp(vector.y, exponent), std::ldexp(vector.z, exponent)};
}

/// Across two derivatives whose product is too large for a number; zero where they are so themselves.
glm::dvec3 across(const glm::dvec3& su, const glm::dvec3& sv) {
  const glm::dvec3 normal = glm::cross(scaled(su), scaled(sv));
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// From the parameter across the span on the side asked for, or back into the domain.
double step_inward(const KnotVector& knots, double u, Side side) {
  const Interval span = knots.span_interval(knots.span_of(u, side));
  return u < span.end && (side == Side::right || u == span.start) ? span.length() : -span.length();
}

}  // namespace

NormalFinder::NormalFinder(const NurbsPatch& patch) : patch_(patch) {
  constexpr double kRelative = 1e-12;
  const double size = extent(patch.points());
  const double rounding = kRelative * std::max(size, largest_coordinate(patch.points()));
  const double length_u = patch.knot_vector(Axis::u).domain().length();
  const double length_v = patch.knot_vector(Axis::v).domain().length();
  negligible_ = (rounding / length_u) * (size / length_v);
}

glm::dvec3 NormalFinder::at(double u, double v, const glm::dvec3& su, const glm::dvec3& sv,
                            PatchOptions options) const {
  const glm::dvec3 normal = glm::cross(su, sv);
  const double length = glm::length(normal);
  if (!std::isfinite(length)) return across(su, sv);
  return length > negligible_ ? normal / length : limit(u, v, options);
}

/// S_u x S_v times W^3, from the homogeneous S = A / W, is W A_u x A_v + W_u A_v x A + W_v A x A_u:
/// as a power series along a straight way into the domain its first coefficient that is not
/// rounding is the direction of the limit.
glm::dvec3 NormalFinder::limit(double u, double v, PatchOptions options) const {
  const KnotVector& knots_u = patch_.knot_vector(Axis::u);
  const KnotVector& knots_v = patch_.knot_vector(Axis::v);
  const LocalDerivatives local = local_derivatives(patch_, Samples::make(knots_u, {&u, 1}, kTerms, options.side_u),
                                                   Samples::make(knots_v, {&v, 1}, kTerms, options.side_v));
  const double a = step_inward(knots_u, u, options.side_u);
  const double b = step_inward(knots_v, v, options.side_v);
  const auto point = along(local, a, b, 0, 0);
  const auto slope_u = along(local, a, b, 1, 0);
  const auto slope_v = along(local, a, b, 0, 1);
  Series<glm::dvec3> normals;
  normals.fill(glm::dvec3(0.0));
  add_product(normals, point, slope_u, slope_v);
  add_product(normals, slope_u, slope_v, point);
  add_product(normals, slope_v, point, slope_u);
  constexpr double kRelative = 1e-11;
  const double rounding = kRelative * std::max(local.offset, local.coordinate);
  const double negligible = local.weight * (rounding / std::abs(a)) * (local.offset / std::abs(b));
  for (const glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    if (!std::isfinite(length)) break;
    if (length > negligible) return (point[0].w < 0.0 ? -normal : normal) / length;
  }
  return glm::dvec3(0.0);
}

}  // namespace splinecore
