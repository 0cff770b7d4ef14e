#include "splinecore/build/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/quotient.hpp"
#include "base/require.hpp"
#include "newton.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

void require_degree(std::size_t conditions) {
  if (conditions <= kMaxDegree + 1) return;
  throw InvalidShape("degree = " + std::to_string(conditions - 1) + " is above " + std::to_string(kMaxDegree) +
                     ": a polynomial has one degree less than it has points and derivatives");
}

void require_data(std::span<const Osculation> data) {
  std::vector<double> parameters;
  std::size_t conditions = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (data[i].derivatives.empty()) throw InvalidShape("data" + index_text(i) + " is empty: it needs a point");
    require_finite(data[i].derivatives, "data" + index_text(i));
    parameters.push_back(data[i].parameter);
    conditions += data[i].derivatives.size();
  }
  if (data.size() < 2) {
    throw InvalidShape("parameters has " + std::to_string(data.size()) + " values, 2 or more are needed");
  }
  require_increasing(parameters, "parameters");
  require_degree(conditions);
}

double size_of(std::span<const glm::dvec3> points) {
  double size = 0.0;
  for (const glm::dvec3& p : points) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return size;
}

/// Largest coordinate of the polynomial at degree + 1 places of the range.
double size_on(const NewtonForm& polynomial, Interval range) {
  std::vector<glm::dvec3> values;
  for (int i = 0; i <= polynomial.degree(); ++i) {
    values.push_back(polynomial.value(range.start + range.length() * i / polynomial.degree()));
  }
  return size_of(values);
}

/// Bernstein spans one after the other; neighbors share a point.
struct Spans {
  std::vector<double> knots;
  std::vector<glm::dvec4> points;
};

void append_span(Interval range, std::span<const glm::dvec3> points, Spans& spans) {
  if (spans.points.empty()) spans.points.emplace_back(points.front(), 1.0);
  for (const glm::dvec3& point : points.subspan(1)) spans.points.emplace_back(point, 1.0);
  spans.knots.insert(spans.knots.end(), points.size() - 1, range.end);
}

/// The polynomial on the range, in halves where its control points are too large: rounded to doubles
/// they would hide the curve. `size` is a size at which rounding does no harm.
void append_spans(const NewtonForm& polynomial, Interval range, double size, int halvings, Spans& spans) {
  constexpr double kMaxGrowth = 1000.0;
  const std::vector<glm::dvec3> points = polynomial.bernstein(range);
  const auto is_small = [&] { return size_of(points) <= kMaxGrowth * std::max(size, size_on(polynomial, range)); };
  const bool can_halve = halvings > 0 && range.start < range.middle() && range.middle() < range.end;
  if (!can_halve || !std::ranges::all_of(points, is_finite) || is_small()) return append_span(range, points, spans);
  append_spans(polynomial, {range.start, range.middle()}, size, halvings - 1, spans);
  append_spans(polynomial, {range.middle(), range.end}, size, halvings - 1, spans);
}

std::vector<double> uniform_parameters(std::size_t count) {
  std::vector<double> parameters(count);
  for (std::size_t i = 0; i < count; ++i) {
    parameters[i] = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(count, 2) - 1);
  }
  return parameters;
}

/// The parameters of the points, checked.
std::vector<double> parameters_for(std::span<const glm::dvec3> points, std::vector<double> parameters) {
  require_finite(points, "points");
  if (points.size() < 2) {
    throw InvalidShape("points has " + std::to_string(points.size()) + " rows, 2 or more are needed");
  }
  if (parameters.empty()) parameters = uniform_parameters(points.size());
  if (parameters.size() != points.size()) {
    throw InvalidShape("parameters has " + std::to_string(parameters.size()) + " values for " +
                       std::to_string(points.size()) + " points");
  }
  require_increasing(parameters, "parameters");
  return parameters;
}

/// 1 / product of u_j - u_i, all of them times one power of two: the largest lies next to 1.
std::vector<double> barycentric_weights(std::span<const double> parameters) {
  std::vector<double> weights(parameters.size());
  std::vector<int> exponents(parameters.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    double product = 1.0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (i == j) continue;
      int exponent = 0;
      product = std::frexp(product * (parameters[j] - parameters[i]), &exponent);
      exponents[j] -= exponent;
    }
    weights[j] = 1.0 / product;
  }
  const int largest = *std::ranges::max_element(exponents);
  for (std::size_t j = 0; j < weights.size(); ++j) weights[j] = std::ldexp(weights[j], exponents[j] - largest);
  return weights;
}

glm::dvec3 barycentric_value(std::span<const glm::dvec3> points, std::span<const double> parameters,
                             std::span<const double> weights, double u) {
  glm::dvec3 sum(0.0);
  double total = 0.0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (u == parameters[j]) return points[j];
    const double share = weights[j] / (u - parameters[j]);
    if (!std::isfinite(share)) return points[j];
    sum += share * points[j];
    total += share;
  }
  return sum / total;
}

}  // namespace

NurbsCurve osculating_polynomial(std::span<const Osculation> data) {
  constexpr int kMaxHalvings = 8;
  require_data(data);
  const Interval domain{data.front().parameter, data.back().parameter};
  const NewtonForm polynomial(data);
  std::vector<glm::dvec3> given;
  for (const Osculation& place : data) given.push_back(place.derivatives[0]);
  Spans spans;
  spans.knots.assign(polynomial.degree() + 1, domain.start);
  append_spans(polynomial, domain, size_of(given), kMaxHalvings, spans);
  spans.knots.push_back(domain.end);
  const auto is_overflow = [](const glm::dvec4& p) { return !is_finite(glm::dvec3(p)); };
  if (std::ranges::any_of(spans.points, is_overflow)) throw InvalidShape("the points of the polynomial overflow");
  spans.points.front() = {given.front(), 1.0};
  spans.points.back() = {given.back(), 1.0};
  return NurbsCurve::make(polynomial.degree(), std::move(spans.knots), std::move(spans.points));
}

NurbsCurve polynomial_through(std::span<const glm::dvec3> points, std::vector<double> parameters) {
  parameters = parameters_for(points, std::move(parameters));
  std::vector<Osculation> data;
  for (std::size_t i = 0; i < points.size(); ++i) data.push_back({parameters[i], {points[i]}});
  return osculating_polynomial(data);
}

void lagrange_evaluate(std::span<const glm::dvec3> points, std::vector<double> parameters,
                       std::span<const double> at, std::span<glm::dvec3> out) {
  parameters = parameters_for(points, std::move(parameters));
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] >= parameters.front() && at[i] <= parameters.back()) continue;
    throw InvalidShape("u" + index_text(i) + " = " + text_of(at[i]) + " is outside [" + text_of(parameters.front()) +
                       ", " + text_of(parameters.back()) + "]");
  }
  const std::vector<double> weights = barycentric_weights(parameters);
  for (std::size_t i = 0; i < at.size(); ++i) {
    out[i] = barycentric_value(points, parameters, weights, at[i]);
    if (!is_finite(out[i])) throw InvalidShape("the polynomial overflows at u" + index_text(i) + " = " + text_of(at[i]));
  }
}

}  // namespace splinecore
