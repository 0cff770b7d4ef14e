#include "exact_polynomial.hpp"

#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

ScaledBernstein lowered_u(const ScaledBernstein& a) {
  const int width = a.degree_v + 1;
  const int degree = a.degree_u - 1;
  ScaledBernstein out{degree, a.degree_v, std::vector<double>((degree + 1) * width)};
  const auto old = [&](int i, int j) { return a.coefficients[i * width + j]; };
  const auto value = [&](int i, int j) -> double& { return out.coefficients[i * width + j]; };
  const int half = (degree + 1) / 2;
  for (int j = 0; j < width; ++j) {
    for (int i = 0; i < half; ++i) value(i, j) = old(i, j) - (i > 0 ? value(i - 1, j) : 0.0);
    for (int i = degree; i >= half; --i) value(i, j) = old(i + 1, j) - (i < degree ? value(i + 1, j) : 0.0);
  }
  return out;
}

ScaledBernstein raised_u(const ScaledBernstein& a) {
  const std::size_t width = a.degree_v + 1;
  ScaledBernstein out{a.degree_u + 1, a.degree_v, a.coefficients};
  out.coefficients.resize(out.coefficients.size() + width, 0.0);
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) out.coefficients[i + width] += a.coefficients[i];
  return out;
}

ScaledBernstein swapped(const ScaledBernstein& a) {
  ScaledBernstein out{a.degree_v, a.degree_u, std::vector<double>(a.coefficients.size())};
  for (int i = 0; i <= a.degree_u; ++i) {
    for (int j = 0; j <= a.degree_v; ++j) {
      out.coefficients[j * (a.degree_u + 1) + i] = a.coefficients[i * (a.degree_v + 1) + j];
    }
  }
  return out;
}

ScaledBernstein with_degrees(ScaledBernstein a, int degree_u, int degree_v) {
  while (a.degree_u < degree_u) a = raised_u(a);
  while (a.degree_u > degree_u) a = lowered_u(a);
  return a.degree_v == degree_v ? a : swapped(with_degrees(swapped(a), degree_v, degree_u));
}

std::vector<double> bezier_ordinates(const ScaledBernstein& a) {
  std::vector<double> ordinates = a.coefficients;
  for (int i = 0; i <= a.degree_u; ++i) {
    for (int j = 0; j <= a.degree_v; ++j) {
      ordinates[i * (a.degree_v + 1) + j] /= binomial(a.degree_u, i) * binomial(a.degree_v, j);
    }
  }
  return ordinates;
}

}  // namespace splinecore
