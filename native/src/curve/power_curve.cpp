#include "splinecore/curve/power_curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "basis/power.hpp"
#include "basis/selection.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/points.hpp"

namespace splinecore {

namespace {

std::string text_of(Interval range) {
  return "(" + splinecore::text_of(range.start) + ", " + splinecore::text_of(range.end) + ")";
}

void require_coefficients(std::span<const glm::dvec4> coefficients) {
  constexpr const char* kAxes = "xyzw";
  if (coefficients.size() < 2) {
    throw InvalidShape("coefficients has " + std::to_string(coefficients.size()) +
                       " rows, a power curve needs 2 or more");
  }
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    for (int axis = 0; axis < 4; ++axis) {
      if (std::isfinite(coefficients[i][axis])) continue;
      throw InvalidShape("coefficients" + index_text(i) + "." + kAxes[axis] + " = " +
                         splinecore::text_of(coefficients[i][axis]) + " is not finite");
    }
  }
  if (std::ranges::all_of(coefficients, [](const glm::dvec4& c) { return c.w == 0.0; })) {
    throw InvalidShape("coefficients: every w is zero, no point of the curve is finite");
  }
}

void require_origin(double origin) {
  if (std::isfinite(origin)) return;
  throw InvalidShape("origin = " + splinecore::text_of(origin) + " is not finite");
}

void require_domain(Interval domain) {
  if (domain.start < domain.end && std::isfinite(domain.length())) return;
  throw InvalidShape("domain = " + text_of(domain) + " is not an interval of positive, finite length");
}

bool is_finite(const glm::dvec4& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

std::vector<glm::dvec4> control_points(std::span<const glm::dvec4> coefficients, double origin, Interval domain) {
  std::vector<glm::dvec4> points = as_given(power_to_bernstein(coefficients, origin, domain));
  if (std::ranges::all_of(points, is_finite)) return points;
  throw InvalidShape("coefficients overflow on the domain " + text_of(domain) + " about origin = " +
                     splinecore::text_of(origin));
}

/// The coefficients of the product of two polynomials.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

std::vector<double> column(std::span<const glm::dvec4> rows, int axis) {
  std::vector<double> values;
  for (const glm::dvec4& row : rows) values.push_back(row[axis]);
  return values;
}

std::vector<double> differentiated(std::vector<double> c) {
  for (std::size_t k = 1; k < c.size(); ++k) c[k - 1] = static_cast<double>(k) * c[k];
  c.back() = 0.0;
  return c;
}

std::vector<glm::dvec4> quotient_derivative(std::span<const glm::dvec4> coefficients) {
  const std::vector<double> weight = column(coefficients, 3);
  const std::vector<double> squared = product(weight, weight);
  std::vector<glm::dvec4> rows(squared.size());
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].w = squared[k];
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> value = column(coefficients, axis);
    const std::vector<double> rising = product(differentiated(value), weight);
    const std::vector<double> falling = product(value, differentiated(weight));
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k][axis] = rising[k] - falling[k];
  }
  return rows;
}

}  // namespace

PowerCurve PowerCurve::make(std::vector<glm::dvec4> coefficients, double origin, Interval domain) {
  require_origin(origin);
  require_coefficients(coefficients);
  require_domain(domain);
  const auto order = static_cast<int>(std::min<std::size_t>(coefficients.size(), 1 << 20));
  std::vector<double> knots(order, domain.start);
  knots.insert(knots.end(), order, domain.end);
  KnotVector basis = KnotVector::make(order - 1, std::move(knots));
  NurbsCurve form = NurbsCurve::make(std::move(basis), control_points(coefficients, origin, domain));
  return {std::move(coefficients), origin, domain, std::move(form)};
}

bool PowerCurve::polynomial() const noexcept {
  const auto is_zero = [](const glm::dvec4& c) { return c.w == 0.0; };
  return coefficients_[0].w == 1.0 && std::all_of(coefficients_.begin() + 1, coefficients_.end(), is_zero);
}

PowerCurve with_origin(const PowerCurve& curve, double origin) {
  require_origin(origin);
  return PowerCurve::make(taylor_shifted(curve.coefficients(), exact_sum(origin, -curve.origin())), origin,
                          curve.domain());
}

PowerCurve with_domain(const PowerCurve& curve, Interval domain) {
  return PowerCurve::make({curve.coefficients().begin(), curve.coefficients().end()}, curve.origin(), domain);
}

PowerCurve derivative(const PowerCurve& curve) {
  if (!curve.polynomial()) {
    return PowerCurve::make(quotient_derivative(curve.coefficients()), curve.origin(), curve.domain());
  }
  std::vector<glm::dvec4> rows;
  for (int k = 1; k <= curve.degree(); ++k) rows.push_back(static_cast<double>(k) * curve.coefficients()[k]);
  if (rows.size() == 1) rows.emplace_back(0.0);
  rows[0].w = 1.0;
  return PowerCurve::make(std::move(rows), curve.origin(), curve.domain());
}

std::pair<PowerCurve, PowerCurve> split(const PowerCurve& curve, double u) {
  require_inside(curve.nurbs().knot_vector(), u);
  return {with_domain(curve, {curve.domain().start, u}), with_domain(curve, {u, curve.domain().end})};
}

PowerCurve reversed(const PowerCurve& curve) {
  // start + end - origin may have more digits than a double: the rest is shifted away.
  const DoubleDouble mirrored = exact_sum(curve.domain().start, curve.domain().end) - curve.origin();
  std::vector<glm::dvec4> rows(curve.coefficients().begin(), curve.coefficients().end());
  for (std::size_t k = 1; k < rows.size(); k += 2) rows[k] = -rows[k];
  return PowerCurve::make(taylor_shifted(rows, -DoubleDouble(mirrored.low)), mirrored.high, curve.domain());
}

}  // namespace splinecore
