#include "derivative_products.hpp"

#include <algorithm>
#include <span>

#include "gram.hpp"

namespace splinecore {

namespace {

/// Adds such rows as those of gram_rows(), from function `first` on, to both halves.
void add_rows(std::size_t first, std::span<const double> rows, std::size_t width, ProductBand& band) {
  for (std::size_t i = 0; i < rows.size() / width; ++i) {
    const std::size_t row = first + i;
    for (std::size_t k = 0; k < width; ++k) {
      const double share = rows[i * width + k];
      band.values[row % band.count * band.width + band.degree + k] += share;
      if (k > 0 && (row + k < band.count || band.is_periodic)) {
        band.values[(row + k) % band.count * band.width + band.degree - k] += share;
      }
    }
  }
}

}  // namespace

ProductBand::ProductBand(const KnotVector& knots)
    : count(static_cast<std::size_t>(knots.count())), degree(static_cast<std::size_t>(knots.degree())),
      width(2 * degree + 1), is_periodic(knots.periodic()), values(count * width, 0.0) {}

ProductBand derivative_products(const KnotVector& knots, int order) {
  ProductBand band(knots);
  add_rows(0, gram_rows(knots, order), band.degree + 1, band);
  return band;
}

ProductBand difference_products(const KnotVector& knots, int order) { return difference_products_from(knots, order, 0.0); }

ProductBand difference_products_from(const KnotVector& knots, int order, double shortest) {
  ProductBand band(knots);
  const int degree = knots.degree() - order;
  if (degree < 0) return band;
  const auto chain = knots.unrolled();
  const auto width = static_cast<std::size_t>(degree) + 1;
  for (const int span : knots.spans()) {
    if (chain[static_cast<std::size_t>(span) + 1] - chain[static_cast<std::size_t>(span)] < shortest) continue;
    const auto near = chain.subspan(static_cast<std::size_t>(span - degree), 2 * width);
    const std::vector<double> rows = gram_rows(KnotVector::make(degree, {near.begin(), near.end()}), 0);
    add_rows(static_cast<std::size_t>(span - degree), rows, width, band);
  }
  return band;
}

std::vector<double> difference_steps(const KnotVector& knots, int order) {
  std::vector<double> steps(static_cast<std::size_t>(knots.count()), 0.0);
  const int reach = knots.degree() - order;
  const auto chain = knots.unrolled();
  for (std::size_t i = knots.periodic() ? 0 : order + 1; i < steps.size() && reach > 0; ++i) {
    const double length = chain[i + static_cast<std::size_t>(reach)] - chain[i];
    if (length > 0.0) steps[i] = reach / length;
  }
  return steps;
}

void write_differences(std::span<const double> steps, std::size_t columns, std::span<const double> from,
                       std::span<double> to) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t before = (i > 0 ? i : steps.size()) - 1;
    for (std::size_t c = 0; c < columns; ++c) {
      to[i * columns + c] = steps[i] * (from[i * columns + c] - from[before * columns + c]);
    }
  }
}

void write_sums_of_differences(std::span<const double> steps, std::size_t columns, std::span<const double> from,
                               std::span<double> to) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t after = i + 1 < steps.size() ? i + 1 : 0;
    for (std::size_t c = 0; c < columns; ++c) {
      to[i * columns + c] = steps[i] * from[i * columns + c] - steps[after] * from[after * columns + c];
    }
  }
}

void write_products(const ProductBand& band, std::size_t columns, std::span<const double> from, std::span<double> to) {
  std::ranges::fill(to, 0.0);
  for (std::size_t i = 0; i < band.count; ++i) {
    for (std::size_t k = 0; k < band.width; ++k) {
      if (!band.has(i, k)) continue;
      const double factor = band.at(i, k);
      const double* const other = &from[band.partner(i, k) * columns];
      for (std::size_t c = 0; c < columns; ++c) to[i * columns + c] += factor * other[c];
    }
  }
}

}  // namespace splinecore
