#include "splinecore/curve/bezier_degree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "base/double_double.hpp"
#include "base/given_points.hpp"
#include "base/length.hpp"
#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

using Points = std::vector<glm::dvec4>;

/// One degree more, with the weights i / n and 1 - i / n of the lectures.
Points raised(const Points& points) {
  const auto degree = static_cast<double>(points.size());
  Points result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double share = static_cast<double>(i) / degree;
    result.push_back(share * points[i - 1] + (1.0 - share) * points[i]);
  }
  result.push_back(points.back());
  return result;
}

/// The difference of order degree: the leading coefficient of the polynomial.
glm::dvec4 leading_coefficient(const Points& points) {
  glm::dvec4 leading;
  for (int axis = 0; axis < 4; ++axis) {
    std::vector<DoubleDouble> row;
    for (const glm::dvec4& point : points) row.emplace_back(point[axis]);
    for (std::size_t count = row.size(); count-- > 1;) {
      for (std::size_t i = 0; i < count; ++i) row[i] = row[i + 1] - row[i];
    }
    leading[axis] = row[0].rounded();
  }
  return leading;
}

/// Bernstein coefficients of t^n + … of smallest maximum on [0, 1] among those that vanish at both ends: the
/// Chebyshev polynomial, stretched until its outermost zeros are the ends. As a product over its zeros all
/// terms of each coefficient have one sign, so nothing cancels.
std::vector<double> constrained_chebyshev(int degree) {
  const double half_step = 0.5 * std::numbers::pi / degree;
  std::vector<double> coefficients{1.0};
  for (int k = 0; k < degree; ++k) {
    // (1 - cos((2 k + 1) h) / cos h) / 2 and the same seen from the other end.
    const double zero = std::sin((k + 1) * half_step) * std::sin(k * half_step) / std::cos(half_step);
    const int other = degree - 1 - k;
    const double rest = std::sin((other + 1) * half_step) * std::sin(other * half_step) / std::cos(half_step);
    const int count = k + 1;
    coefficients.push_back(0.0);
    for (int i = count; i >= 0; --i) {
      const double below = i > 0 ? coefficients[i - 1] * i * rest : 0.0;
      coefficients[i] = (below - coefficients[i] * (count - i) * zero) / count;
    }
  }
  return coefficients;
}

/// Its maximum: 2^(1 - 2n) / cos(pi / 2n)^n.
double constrained_maximum(int degree) {
  return std::exp2(1 - 2 * degree) / std::pow(std::cos(0.5 * std::numbers::pi / degree), degree);
}

/// raised() undone: from both ends to the middle, where each step makes errors smaller.
Points lowered(const Points& points) {
  const std::size_t degree = points.size() - 1;
  const auto n = static_cast<double>(degree);
  Points result(degree);
  result.front() = points.front();
  result.back() = points.back();
  for (std::size_t i = 1; i < (degree + 1) / 2; ++i) {
    const auto k = static_cast<double>(i);
    result[i] = (n * points[i] - k * result[i - 1]) / (n - k);
  }
  for (std::size_t i = degree - 1; i-- > (degree + 1) / 2;) {
    const auto k = static_cast<double>(degree - 1 - i);
    result[i] = (n * points[i + 1] - k * result[i + 1]) / (n - k);
  }
  return result;
}

double smallest_weight(const Points& points) {
  return std::ranges::min(points, {}, &glm::dvec4::w).w;
}


/// How far the quotient of the homogeneous points moves at most where they move by `change`, into `after`:
/// (X - P W) / W over the hull of the points P.
double bound(const glm::dvec4& change, const Points& before, const Points& after) {
  const double weight = smallest_weight(before);
  if (change.w == 0.0) return length_of(glm::dvec3(change)) / weight;
  double largest = 0.0;
  for (const glm::dvec4& point : as_given(after)) {
    largest = std::max(largest, length_of(glm::dvec3(change) - change.w * glm::dvec3(point)));
  }
  return largest / weight;
}

void require_one_sign(std::span<const glm::dvec4> points, const char* when = "") {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = points[i].w;
    if (points[0].w < 0.0 ? w < 0.0 : w > 0.0) continue;
    throw InvalidShape("weights" + index_text(i) + " = " + text_of(w) + when +
                       ": the degree is reduced only where all weights have one sign");
  }
}

/// One degree less, and how far the curve moved at most.
Approximation<Points> one_lower(const Points& points) {
  const int degree = static_cast<int>(points.size()) - 1;
  const glm::dvec4 leading = leading_coefficient(points);
  const std::vector<double> chebyshev = constrained_chebyshev(degree);
  Points nearest = points;
  for (int i = 1; i < degree; ++i) nearest[i] -= leading * chebyshev[i];
  Points result = lowered(nearest);
  require_one_sign(result, " after a step");
  const double error = bound(leading * constrained_maximum(degree), points, result);
  return {std::move(result), error};
}

void require_times(int times, int least, int most) {
  if (times >= least && times <= most) return;
  throw InvalidShape("times = " + std::to_string(times) + " is outside [" + std::to_string(least) + ", " +
                     std::to_string(most) + "]");
}

/// The same points with weights of the other sign.
void turn(Points& points) {
  for (glm::dvec4& point : points) point = -point;
}

BezierCurve with_ends(const Points& points, const BezierCurve& curve) {
  auto [made, old, divided] = as_given_from(curve.nurbs(), points);
  made.front() = old.front();
  made.back() = old.back();
  return BezierCurve::make(std::move(made));
}

Points homogeneous_points(const BezierCurve& curve) {
  const auto points = curve.nurbs().homogeneous_points();
  return {points.begin(), points.end()};
}

}  // namespace

BezierCurve elevated(const BezierCurve& curve, int times) {
  require_times(times, 0, kMaxDegree - curve.degree());
  if (times == 0) return curve;
  Points points = homogeneous_points(curve);
  for (int i = 0; i < times; ++i) points = raised(points);
  return with_ends(points, curve);
}

Approximation<BezierCurve> reduced(const BezierCurve& curve, int times) {
  if (curve.degree() == 1) throw InvalidShape("degree = 1 cannot be reduced");
  require_times(times, 1, curve.degree() - 1);
  Points points = homogeneous_points(curve);
  const bool is_negative = points.front().w < 0.0;
  if (is_negative) turn(points);
  require_one_sign(curve.points());
  double error = 0.0;
  for (int i = 0; i < times; ++i) {
    Approximation<Points> lower = one_lower(points);
    points = std::move(lower.value);
    error += lower.error;
  }
  if (is_negative) turn(points);
  if (!std::isfinite(error)) throw InvalidShape("points are so large that the error overflows");
  return {with_ends(points, curve), error};
}

Approximation<BezierCurve> reduced(const BezierCurve& curve, int times, double tolerance) {
  require_tolerance(tolerance);
  Approximation<BezierCurve> result = reduced(curve, times);
  if (result.error <= tolerance) return result;
  throw ToleranceNotReached("the degree cannot be reduced", tolerance, result.error);
}

}  // namespace splinecore
