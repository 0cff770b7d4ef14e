#include "grid_controls.hpp"

#include <cstddef>

#include "fit/row_spline.hpp"
#include "greville.hpp"

namespace splinecore {

std::vector<double> grid_controls(const KnotVector& u, const KnotVector& v, const std::vector<double>& values) {
  std::vector<double> found = values;
  for (const KnotVector* const knots : {&u, &v}) {
    const auto rows = static_cast<std::size_t>(knots->count());
    const std::size_t width = found.size() / rows;
    RowConditions given{greville_places(*knots), {}, {}, {}};
    for (std::size_t i = 0; i < rows; ++i) given.rows.emplace_back(found.begin() + i * width, found.begin() + (i + 1) * width);
    const std::vector<double> controls =
        spline_through(given, knots->degree(), Closing::open, {knots->knots().begin(), knots->knots().end()}).controls;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < width; ++j) found[j * rows + i] = controls[i * width + j];
    }
  }
  return found;
}

}  // namespace splinecore
