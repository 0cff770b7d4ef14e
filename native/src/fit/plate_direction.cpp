#include "plate_direction.hpp"

#include <cmath>

#include "gram.hpp"

namespace splinecore {

namespace {

/// The mean over the plate of products of derivatives, beside the integral over the domain.
double mean_factor(const PlateAxis& axis, int order) {
  return std::pow(axis.length / axis.knots.domain().length(), 1 - 2 * order) / axis.length;
}

/// Adds such rows as those of gram_rows(), from function `first` on, to both halves of a band.
void add_rows(const PlateDirection& to, std::size_t first, std::span<const double> rows, std::size_t width, double factor,
              PlateBand& band) {
  for (std::size_t i = 0; i < rows.size() / width; ++i) {
    const std::size_t row = first + i;
    for (std::size_t k = 0; k < width; ++k) {
      const double share = factor * rows[i * width + k];
      band.values[row % to.count * band.width + to.degree + k] += share;
      if (k > 0 && (row + k < to.count || to.is_periodic)) {
        band.values[(row + k) % to.count * band.width + to.degree - k] += share;
      }
    }
  }
}

/// Integrals of products of the functions of the derivative of an order, which lie on the same knots.
PlateBand mass_of(const PlateDirection& direction, const PlateAxis& axis, int order) {
  PlateBand band{std::vector<double>(direction.count * (2 * direction.degree + 1), 0.0), 2 * direction.degree + 1};
  const int degree = axis.knots.degree() - order;
  if (degree < 0) return band;
  const auto knots = axis.knots.unrolled();
  const auto width = static_cast<std::size_t>(degree) + 1;
  for (const int span : axis.knots.spans()) {
    const auto near = knots.subspan(static_cast<std::size_t>(span - degree), 2 * width);
    const std::vector<double> rows = gram_rows(KnotVector::make(degree, {near.begin(), near.end()}), 0);
    add_rows(direction, static_cast<std::size_t>(span - degree), rows, width, mean_factor(axis, order), band);
  }
  return band;
}

/// No difference reaches over the ends, or over knots where a function ends before it starts.
std::vector<double> steps_of(const PlateDirection& direction, const PlateAxis& axis, int order) {
  std::vector<double> steps(direction.count, 0.0);
  const int reach = axis.knots.degree() - order;
  const auto knots = axis.knots.unrolled();
  for (std::size_t i = direction.is_periodic ? 0 : order + 1; i < direction.count && reach > 0; ++i) {
    const double length = knots[i + static_cast<std::size_t>(reach)] - knots[i];
    if (length > 0.0) steps[i] = reach / length;
  }
  return steps;
}

}  // namespace

PlateDirection::PlateDirection(const PlateAxis& axis, bool is_outer)
    : count(static_cast<std::size_t>(axis.knots.count())), degree(static_cast<std::size_t>(axis.knots.degree())),
      is_periodic(axis.knots.periodic()), is_folded(is_outer && is_periodic), held(axis.held) {
  for (int order = 0; order <= 2; ++order) {
    PlateBand& band = bands[order];
    band = {std::vector<double>(count * (2 * degree + 1), 0.0), 2 * degree + 1};
    add_rows(*this, 0, gram_rows(axis.knots, order), degree + 1, mean_factor(axis, order), band);
    masses[order] = mass_of(*this, axis, order);
    if (order > 0) steps[order - 1] = steps_of(*this, axis, order - 1);
  }
}

std::size_t PlateDirection::place(std::size_t i) const noexcept {
  if (!is_folded) return i - held.start;
  return 2 * i < count ? 2 * i : 2 * (count - 1 - i) + 1;
}

}  // namespace splinecore
