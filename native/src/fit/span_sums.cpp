#include "span_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "kernels/kernels.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

namespace {

constexpr int kMostKernelDegree = std::size(decltype(Kernels::power_sums){});
constexpr std::size_t kMostKernelNumbers = 2 * kMostKernelDegree + 1;

/// Nothing where the kernels do not reach.
std::optional<SpanPoints> kernel_points(const SpanParameters& at, double scale, const double* values) {
  constexpr double kLeastScale = 0x1p-990;
  const double share = 1.0 / (at.span.end - at.span.start);
  if (at.degree < 1 || at.degree > kMostKernelDegree || !std::isfinite(share) || !(scale > kLeastScale)) return {};
  const double* const weights = at.weights.empty() ? nullptr : at.weights.data();
  return SpanPoints{at.span.start, at.span.end, share, scale, at.weight_scale, at.parameters.size(),
                    at.parameters.data(), weights, values};
}

/// All Bernstein polynomials of the degree row.size() - 1 at t (The NURBS Book, A1.3).
void write_bernstein(double t, std::span<double> row) {
  const double rest = 1.0 - t;
  row[0] = 1.0;
  for (std::size_t k = 1; k < row.size(); ++k) {
    double carried = 0.0;
    for (std::size_t j = 0; j < k; ++j) {
      const double value = row[j];
      row[j] = carried + rest * value;
      carried = t * value;
    }
    row[k] = carried;
  }
}

/// Calls `take` with the index, the weight and the polynomials of each parameter.
template <class Take>
void each_row(const SpanParameters& at, const Take& take) {
  std::vector<double> row(static_cast<std::size_t>(at.degree) + 1);
  for (std::size_t i = 0; i < at.parameters.size(); ++i) {
    const double t = (at.parameters[i] - at.span.start) / (at.span.end - at.span.start);
    write_bernstein(std::clamp(t, 0.0, 1.0), row);
    take(i, at.weights.empty() ? 1.0 : at.weights[i] * at.weight_scale, std::span<const double>(row));
  }
}

/// Calls `take` also with what is left of each row of the values.
template <class Take>
void each_residual(const SpanParameters& at, std::span<const double> values, std::size_t columns,
                   std::span<const double> piece, const Take& take) {
  std::vector<double> left(columns);
  each_row(at, [&](std::size_t i, double weight, std::span<const double> row) {
    std::copy_n(values.data() + i * columns, columns, left.data());
    for (std::size_t j = 0; j < row.size(); ++j) {
      for (std::size_t c = 0; c < columns; ++c) left[c] -= row[j] * piece[j * columns + c];
    }
    take(weight, row, std::span<const double>(left));
  });
}

void add_residual(double weight, std::span<const double> row, std::span<const double> left, std::span<double> sums) {
  const std::size_t columns = left.size();
  for (std::size_t j = 0; j < row.size(); ++j) {
    const double factor = weight * row[j];
    for (std::size_t c = 0; c < columns; ++c) sums[j * columns + c] += factor * left[c];
  }
}

}  // namespace

void write_products(const SpanParameters& at, std::span<double> matrix) {
  const auto width = static_cast<std::size_t>(at.degree) + 1;
  std::ranges::fill(matrix, 0.0);
  if (const auto points = kernel_points(at, 1.0, nullptr)) {
    const double* const choose = binomials(at.degree);
    std::array<double, kMostKernelNumbers> sums;
    kernels().power_sums[at.degree - 1](*points, sums.data());
    for (std::size_t a = 0; a < width; ++a) {
      for (std::size_t b = a; b < width; ++b) {
        matrix[a * width + b] = choose[a] * choose[b] * sums[a + b];
      }
    }
    return;
  }
  each_row(at, [&](std::size_t, double weight, std::span<const double> row) {
    for (std::size_t a = 0; a < width; ++a) {
      const double factor = weight * row[a];
      for (std::size_t b = a; b < width; ++b) matrix[a * width + b] += factor * row[b];
    }
  });
}

void write_residuals(const SpanParameters& at, std::span<const double> values, std::size_t columns,
                     std::span<const double> piece, std::span<double> sums) {
  std::ranges::fill(sums, 0.0);
  each_residual(at, values, columns, piece,
                [&](double weight, std::span<const double> row, std::span<const double> left) {
                  add_residual(weight, row, left, sums);
                });
}

double write_residuals(const SpanParameters& at, std::span<const double> values, std::span<const double> piece,
                       double scale, std::span<double> sums) {
  if (const auto points = kernel_points(at, scale, values.data())) {
    const double* const choose = binomials(at.degree);
    std::array<double, 3 * (kMostKernelDegree + 1)> scaled;
    for (std::size_t k = 0; k < piece.size(); ++k) scaled[k] = -choose[k / 3] * piece[k];
    const double largest = kernels().residual_sums[at.degree - 1](*points, scaled.data(), sums.data());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] *= choose[k / 3];
    return largest;
  }
  std::ranges::fill(sums, 0.0);
  double largest = 0.0;
  each_residual(at, values, 3, piece,
                [&](double weight, std::span<const double> row, std::span<const double> left) {
                  add_residual(weight, row, left, sums);
                  double square = 0.0;
                  for (const double number : left) square += (number * scale) * (number * scale);
                  largest = std::max(largest, square);
                });
  return largest;
}

}  // namespace splinecore
