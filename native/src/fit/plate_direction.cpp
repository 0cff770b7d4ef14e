#include "plate_direction.hpp"

#include <cmath>

namespace splinecore {

namespace {

/// As means over the plate, of lengths on it.
ProductBand on_plate(ProductBand band, const PlateAxis& axis, int order) {
  const double factor = std::pow(axis.length / axis.knots.domain().length(), 1 - 2 * order) / axis.length;
  for (double& value : band.values) value *= factor;
  return band;
}

template <class Products>
std::array<ProductBand, 3> of_orders(const PlateAxis& axis, const Products& products) {
  const auto of = [&](int order) { return on_plate(products(axis.knots, order), axis, order); };
  return {of(0), of(1), of(2)};
}

}  // namespace

PlateDirection::PlateDirection(const PlateAxis& axis, bool is_outer)
    : count(static_cast<std::size_t>(axis.knots.count())), is_folded(is_outer && axis.knots.periodic()),
      held(axis.held), bands(of_orders(axis, derivative_products)), masses(of_orders(axis, difference_products)),
      steps{difference_steps(axis.knots, 0), difference_steps(axis.knots, 1)} {}

std::size_t PlateDirection::place(std::size_t i) const noexcept {
  if (!is_folded) return i - held.start;
  return 2 * i < count ? 2 * i : 2 * (count - 1 - i) + 1;
}

}  // namespace splinecore
